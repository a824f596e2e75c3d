/**
 * The formats of picture files and the sRGB curve, which the module does not export.
 *
 * <p>A format has a reader and a writer. {@link io.github.lumbre.image.internal.ImageFormat} knows
 * the endings of names and the first bytes of files.
 */
package io.github.lumbre.image.internal;
