/** Checks and writes JPEG files; Java decodes them. */
package io.github.lumbre.image.format.jpeg;
