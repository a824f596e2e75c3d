/**
 * Linear colors, pictures, transfer curves and picture files.
 *
 * <p>{@link io.github.lumbre.image.Rgb} is a color or a radiance, and {@link
 * io.github.lumbre.image.Image} is a raster of them. Inside the program all values are linear; the
 * sRGB curve is applied only when files are read or written.
 *
 * <p>For output, {@link io.github.lumbre.image.ImageWriter} writes a picture to an {@link
 * io.github.lumbre.file.OutputFile}. In formats for display it applies {@link
 * io.github.lumbre.image.Exposure} and {@link io.github.lumbre.image.ToneCurve}. For input, {@link
 * io.github.lumbre.image.ImageReader} decodes untrusted files to {@link
 * io.github.lumbre.image.Pixels}, and {@link io.github.lumbre.image.LinearReader} decodes all
 * supported formats to linear light. Rows are counted from the top, except inside PFM files.
 *
 * <p>All public types are immutable or stateless, and safe for use by any thread.
 */
package io.github.lumbre.image;
