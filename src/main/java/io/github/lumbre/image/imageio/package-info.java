/** Decodes pictures with Java's own decoders, whose input was checked before. */
package io.github.lumbre.image.imageio;
