/**
 * Measurements of the time and error of render settings.
 *
 * <p>{@link io.github.lumbre.lab.trade.TradeStudy} measures the settings of a {@link
 * io.github.lumbre.lab.trade.TradeSweep}; {@link io.github.lumbre.lab.trade.TradePage} shows the
 * result.
 */
package io.github.lumbre.lab.trade;
