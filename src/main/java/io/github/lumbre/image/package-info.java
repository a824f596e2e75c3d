/**
 * Linear colour, pictures, transfer curves and picture files.
 *
 * <p>{@link io.github.lumbre.image.Rgb} is a colour or a radiance, {@link
 * io.github.lumbre.image.Image} a raster of them. Inside the program all values are linear light;
 * the sRGB curve exists only at the edge, where files are read and written.
 */
package io.github.lumbre.image;
