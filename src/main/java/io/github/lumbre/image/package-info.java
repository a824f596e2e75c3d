/**
 * Linear colors, pictures, transfer curves and picture files.
 *
 * <p>{@link io.github.lumbre.image.Rgb} is a color or a radiance, and {@link
 * io.github.lumbre.image.Image} is a raster of them. Inside the program all values are linear; the
 * sRGB curve is applied only when files are read or written.
 *
 * <p>The way out: {@link io.github.lumbre.image.ImageWriter} writes a picture, with {@link
 * io.github.lumbre.image.Exposure} and {@link io.github.lumbre.image.ToneCurve} if the format is
 * for the screen. The way in: {@link io.github.lumbre.image.ImageReader} decodes files of unknown
 * origin, to {@link io.github.lumbre.image.Pixels} or to linear light. Rows are counted from the
 * top, but for the inside of PFM files. Each format has a package here, which the module does not
 * export.
 *
 * <p>All public types are immutable or stateless, and safe for use by any thread.
 */
@NullMarked
package io.github.lumbre.image;

import org.jspecify.annotations.NullMarked;
