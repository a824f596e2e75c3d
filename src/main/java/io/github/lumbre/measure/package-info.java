/**
 * How far a picture is from the truth, and what that costs.
 *
 * <p>{@link io.github.lumbre.measure.PictureError} compares a picture with a reference, in linear
 * light and as eyes see it ({@link io.github.lumbre.measure.Flip}, {@link
 * io.github.lumbre.measure.Ssim}); {@link io.github.lumbre.measure.ErrorMap} shows where the error
 * is. Colours count multiplied by alpha, as they look over black. All types are immutable or
 * without state, and safe for use by any thread.
 */
package io.github.lumbre.measure;
