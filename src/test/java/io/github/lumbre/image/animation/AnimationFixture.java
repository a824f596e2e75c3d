package io.github.lumbre.image.animation;

import io.github.lumbre.image.Pixels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntBinaryOperator;

/** Frames of animations for tests. */
public final class AnimationFixture {
  private AnimationFixture() {}

  /** Returns a picture of 8 bits per channel. */
  public static Pixels pixels(int width, int height, boolean hasAlpha, IntBinaryOperator argb) {
    int channels = hasAlpha ? 4 : 3;
    byte[] values = new byte[channels * width * height];
    for (int i = 0; i < width * height; i++) {
      int value = argb.applyAsInt(i % width, i / width);
      for (int c = 0; c < channels; c++) {
        values[channels * i + c] = (byte) (c == 3 ? value >>> 24 : value >> 16 - 8 * c);
      }
    }
    return Pixels.of(width, height, channels, values);
  }

  /** Writes pictures as PNG files, and returns them as frames. */
  public static AnimationFrames frames(Path folder, String rate, Pixels... pictures)
      throws IOException {
    List<Path> files = new ArrayList<>();
    for (Pixels picture : pictures) {
      Path file = folder.resolve("frame-%03d.png".formatted(files.size()));
      files.add(Files.write(file, picture.toPng()));
    }
    return AnimationFrames.open(files, FrameRate.parse(rate));
  }
}
