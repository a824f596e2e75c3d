/** Writes animated GIF files, in whole numbers only: the same bytes on every machine. */
package io.github.lumbre.image.format.gif;
