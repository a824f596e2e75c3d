/**
 * How far a picture is from the truth, and what that costs.
 *
 * <p>{@link io.github.lumbre.measure.PictureError} compares a picture with a reference, in linear
 * light and as eyes see it ({@link io.github.lumbre.measure.Flip}, {@link
 * io.github.lumbre.measure.Ssim}); {@link io.github.lumbre.measure.ErrorMap} shows where the error
 * is. {@link io.github.lumbre.measure.TradeStudy} measures what the settings of a {@link
 * io.github.lumbre.measure.TradeSweep} cost and how wrong they are; {@link
 * io.github.lumbre.measure.TradePage} and {@link io.github.lumbre.measure.SceneTables} show it.
 * Colours count multiplied by alpha, as they look over black. All types are immutable or without
 * state, and safe for use by any thread.
 */
package io.github.lumbre.measure;
