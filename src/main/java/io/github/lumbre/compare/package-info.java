/**
 * Comparison of a picture with a reference.
 *
 * <p>{@link io.github.lumbre.compare.PictureError} compares in linear light and with perceptual
 * metrics ({@link io.github.lumbre.compare.Flip}, {@link io.github.lumbre.compare.Ssim}); {@link
 * io.github.lumbre.compare.internal.ErrorMap} and {@link io.github.lumbre.compare.Flip#picture} show where
 * the difference is. Colors are multiplied by alpha, as if over black. All types are immutable or
 * stateless, and thread-safe.
 */
@NullMarked
package io.github.lumbre.compare;

import org.jspecify.annotations.NullMarked;
