/**
 * How far a picture is from a reference, and statistics of measurements.
 *
 * <p>{@link io.github.lumbre.lab.metrics.PictureError} compares in linear light and by perception
 * ({@link io.github.lumbre.lab.metrics.Flip}, {@link io.github.lumbre.lab.metrics.Ssim}); {@link
 * io.github.lumbre.lab.metrics.ErrorMap} shows where the error is. Colors are multiplied by alpha,
 * as they look over black. All types are immutable or without state, and safe for use by any
 * thread.
 */
package io.github.lumbre.lab.metrics;
