package io.github.lumbre.image.animation;

import io.github.lumbre.file.OutputFile;
import io.github.lumbre.image.gif.GifWriter;
import io.github.lumbre.image.png.ApngWriter;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;

/** The formats of animation files. */
public enum AnimationFormat {
  /** GIF: at most 256 colors, transparent or opaque, played for ever. */
  GIF,
  /** Animated PNG: the frames as they are, played for ever. */
  APNG,
  /** MPEG-4, written by the installed program ffmpeg. */
  MP4,
  /** WebM, written by the installed program ffmpeg. */
  WEBM;

  private static final int MAX_GIF_SIDE = 65535;

  /** Viewers show a GIF frame of less than 1/50 s for 1/10 s. */
  private static final int MAX_GIF_RATE = 50;

  /** Returns the file name extension of the format with its dot, for example {@code .gif}. */
  public String ending() {
    return "." + name().toLowerCase(Locale.ROOT);
  }

  /** Returns all extensions, for messages: {@code .gif, .apng, .mp4, .webm}. */
  public static String endings() {
    return Arrays.stream(values()).map(AnimationFormat::ending).collect(Collectors.joining(", "));
  }

  /** Returns the format of a file by its extension, ignoring case; empty if it is no animation. */
  public static Optional<AnimationFormat> of(Path file) {
    String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    return Arrays.stream(values()).filter(format -> name.endsWith(format.ending())).findFirst();
  }

  /** Returns whether the format is written by the installed program ffmpeg. */
  public boolean isVideo() {
    return this == MP4 || this == WEBM;
  }

  /**
   * Checks that the format can hold frames of a size and a rate; to be called before they are
   * rendered.
   *
   * @throws IllegalArgumentException if it cannot; the message states what to choose instead
   */
  public void requireFits(int width, int height, FrameRate rate) {
    if (this != GIF) {
      return;
    }
    if (width > MAX_GIF_SIDE || height > MAX_GIF_SIDE) {
      throw new IllegalArgumentException(
          "a GIF has at most %d pixels per side, found %dx%d; choose %s"
              .formatted(MAX_GIF_SIDE, width, height, APNG.ending()));
    }
    if (rate.isAbove(MAX_GIF_RATE)) {
      throw new IllegalArgumentException(
          "a GIF has at most %d frames per second, found %s, which viewers play slowly; choose %s"
              .formatted(MAX_GIF_RATE, rate, APNG.ending()));
    }
  }

  /**
   * Writes an animation that is no video to a reserved file and commits it.
   *
   * @param texts metadata by keyword, as in {@link
   *     io.github.lumbre.image.ImageWriter.Options#metadata}; left out of a GIF
   * @throws IllegalArgumentException if the format is a video, or {@link #requireFits} refuses it
   * @throws IOException if a frame cannot be read or the file not be written; the file stays
   *     reserved
   * @throws InterruptedException if the thread is interrupted; the file stays reserved
   */
  public void write(AnimationFrames frames, Map<String, String> texts, OutputFile output)
      throws IOException, InterruptedException {
    requireFits(frames.width(), frames.height(), frames.rate());
    try {
      OutputStream out = new BufferedOutputStream(Channels.newOutputStream(output.restart()));
      switch (this) {
        case GIF -> GifWriter.write(frames, out);
        case APNG -> ApngWriter.write(frames, texts, out);
        default ->
            throw new IllegalArgumentException(this + ": expected a format without a program");
      }
      out.flush();
      output.commit();
    } catch (CancellationException | ClosedByInterruptException e) {
      Thread.interrupted();
      throw (InterruptedException) new InterruptedException("interrupted").initCause(e);
    }
  }
}
