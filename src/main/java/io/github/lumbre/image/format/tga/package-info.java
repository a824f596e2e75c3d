/** Reads Truevision TGA files. */
package io.github.lumbre.image.format.tga;
