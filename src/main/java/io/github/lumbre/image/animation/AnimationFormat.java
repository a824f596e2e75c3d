package io.github.lumbre.image.animation;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.format.gif.GifWriter;
import io.github.lumbre.image.format.png.ApngWriter;
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

  /** Viewers show a GIF frame of less than 1/50 s for 1/10 s. */
  private static final int MAX_GIF_RATE = 50;

  /** The most pixels on a side: GIF has 16 bits for them. */
  static final int MAX_SIDE = 65535;

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

  /** Returns what the format makes of transparent frames, for people; empty if it keeps them. */
  public Optional<String> lostTransparency() {
    return switch (this) {
      case APNG -> Optional.empty();
      case GIF ->
          Optional.of("a GIF has no partial transparency: alpha below one half is transparent");
      case MP4, WEBM -> Optional.of("a video has no transparency: the frames are shown over black");
    };
  }

  /**
   * Checks that the format can hold a rate of frames; to be called before they are rendered.
   *
   * @throws IllegalArgumentException if it cannot; the message states what to choose instead
   */
  public void requireFits(FrameRate rate) {
    if (this == GIF && rate.isAbove(MAX_GIF_RATE)) {
      throw new IllegalArgumentException(
          "a GIF has at most %d frames per second, found %s, which viewers play slowly; choose %s"
              .formatted(MAX_GIF_RATE, rate, APNG.ending()));
    }
  }

  /**
   * Checks the size of frames.
   *
   * @param what has the limit, such as {@code a GIF}
   * @param most pixels on a side
   */
  static void requireFits(String what, int most, int width, int height) {
    if (Math.max(width, height) > most || (long) width * height > ImageReader.MAX_PIXELS) {
      throw new IllegalArgumentException(
          "%s has at most %d pixels on a side and %d in all, found %dx%d; choose a smaller size"
              .formatted(what, most, ImageReader.MAX_PIXELS, width, height));
    }
  }

  /**
   * Returns a writer of this format. For a video it finds the installed program ffmpeg and one of
   * its encoders, so that a missing one is known before the frames are rendered.
   *
   * @param ffmpeg path of the program or of its folder; if empty, the variable LUMBRE_FFMPEG states
   *     it, or else the program is sought in the folders of {@code PATH}
   * @param environment the environment variables, such as {@link System#getenv()}
   * @throws IOException if the program is not found, fails, or lacks the encoders of the format
   * @throws InterruptedException if the thread is interrupted
   */
  public AnimationWriter writer(Optional<Path> ffmpeg, Map<String, String> environment)
      throws IOException, InterruptedException {
    return isVideo() ? VideoWriter.find(this, ffmpeg, environment) : this::write;
  }

  private void write(AnimationFrames frames, Map<String, String> texts, OutputFile output)
      throws IOException, InterruptedException {
    requireFits(frames.rate());
    if (this == GIF) {
      commit(output, out -> GifWriter.write(frames, out));
    } else {
      commit(output, out -> ApngWriter.write(frames, texts, out));
    }
  }

  /** Writes the content of a file. */
  @FunctionalInterface
  interface Content {
    void writeTo(OutputStream out) throws IOException;
  }

  /** Writes a reserved file and commits it. An interrupt in any form ends it with one exception. */
  static void commit(OutputFile output, Content content) throws IOException, InterruptedException {
    try {
      OutputStream out = new BufferedOutputStream(Channels.newOutputStream(output.restart()));
      content.writeTo(out);
      out.flush();
      output.commit();
    } catch (CancellationException | ClosedByInterruptException e) {
      Thread.interrupted();
      throw (InterruptedException) new InterruptedException("interrupted").initCause(e);
    }
  }
}
