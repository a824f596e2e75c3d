/**
 * Removes noise from pictures: {@link io.github.lumbre.render.denoise.BuiltInDenoiser} in Java, and
 * {@link io.github.lumbre.render.denoise.OpenImageDenoise} by an installed program.
 *
 * <p>A denoised picture is an estimate: it is biased, and error bounds of the render do not hold
 * for it.
 */
@NullMarked
package io.github.lumbre.render.denoise;

import org.jspecify.annotations.NullMarked;
