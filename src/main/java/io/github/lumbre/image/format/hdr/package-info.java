/** Reads Radiance HDR files: linear light with a common exponent for each pixel. */
package io.github.lumbre.image.format.hdr;
