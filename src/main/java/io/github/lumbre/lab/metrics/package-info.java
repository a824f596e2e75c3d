/**
 * Error metrics of pictures against a reference, and statistics of measurements.
 *
 * <p>{@link io.github.lumbre.lab.metrics.PictureError} compares in linear light and with perceptual
 * metrics ({@link io.github.lumbre.lab.metrics.Flip}, {@link io.github.lumbre.lab.metrics.Ssim});
 * {@link io.github.lumbre.lab.metrics.ErrorMap} shows where the error is. Colors are multiplied by
 * alpha, as if over black. All types are immutable or stateless, and thread-safe.
 */
package io.github.lumbre.lab.metrics;
