/** SVG files, written from drawings of lines and areas. */
@NullMarked
package io.github.lumbre.image.format.svg;

import org.jspecify.annotations.NullMarked;
