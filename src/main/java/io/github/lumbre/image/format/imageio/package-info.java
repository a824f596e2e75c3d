/**
 * Pictures of Java: decodes with Java's own decoders, whose input was checked before, and makes a
 * {@code BufferedImage} of a picture for display.
 */
package io.github.lumbre.image.format.imageio;
