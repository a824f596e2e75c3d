/** Reads and writes OpenEXR files: linear light with alpha, layers and metadata. */
package io.github.lumbre.image.format.exr;
