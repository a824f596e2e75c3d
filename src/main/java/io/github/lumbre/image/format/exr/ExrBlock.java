package io.github.lumbre.image.format.exr;

import java.util.List;

/**
 * The pixels that are packed together. When they are unpacked, each line has the values of one
 * channel after the other.
 *
 * @param width in pixels
 * @param height in lines
 */
record ExrBlock(List<ExrChannel> channels, int width, int height) {
  int lineBytes() {
    return width * channels.stream().mapToInt(channel -> channel.type().bytes()).sum();
  }

  /** Returns the number of bytes of all lines. */
  int bytes() {
    return height * lineBytes();
  }
}
