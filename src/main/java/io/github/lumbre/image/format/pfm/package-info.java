/** Reads and writes portable float maps: linear light without metadata. */
package io.github.lumbre.image.format.pfm;
