/** Reads DDS files with one picture, block-compressed or not. */
package io.github.lumbre.image.format.dds;
