/**
 * Decodes still WebP pictures, lossy and lossless, to the values of libwebp.
 *
 * <p>{@link io.github.lumbre.image.format.webp.WebpFile} reads the container. {@link
 * io.github.lumbre.image.format.webp.Vp8Decoder} decodes lossy pictures, {@link
 * io.github.lumbre.image.format.webp.LosslessDecoder} lossless ones, and {@link
 * io.github.lumbre.image.format.webp.AlphaPlane} the alpha of lossy ones. Sources: RFC 9649
 * (container and lossless format) and RFC 6386 (VP8).
 */
package io.github.lumbre.image.format.webp;
