/**
 * What the formats of picture files have in common, and the sRGB curve.
 *
 * <p>{@link io.github.lumbre.image.internal.ImageFormat} knows the formats by the endings of names
 * and the first bytes of files.
 */
package io.github.lumbre.image.internal;
