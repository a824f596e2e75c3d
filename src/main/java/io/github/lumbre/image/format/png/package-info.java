/** Checks and writes PNG files; Java decodes them. */
package io.github.lumbre.image.format.png;
