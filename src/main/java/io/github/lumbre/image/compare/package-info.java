/**
 * Comparison of a picture with a reference.
 *
 * <p>{@link io.github.lumbre.image.compare.PictureError} compares in linear light and with
 * perceptual metrics ({@link io.github.lumbre.image.compare.Flip}, {@link
 * io.github.lumbre.image.compare.Ssim}); {@link io.github.lumbre.image.compare.internal.ErrorMap}
 * and {@link io.github.lumbre.image.compare.Flip#picture} show where the difference is. Colors are
 * multiplied by alpha, as if over black. All types are immutable or stateless, and thread-safe.
 */
@NullMarked
package io.github.lumbre.image.compare;

import org.jspecify.annotations.NullMarked;
