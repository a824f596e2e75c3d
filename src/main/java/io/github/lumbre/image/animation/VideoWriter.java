package io.github.lumbre.image.animation;

import io.github.lumbre.base.file.ExternalProgram;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.base.file.PrivateFolder;
import io.github.lumbre.image.internal.Srgb;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Writes videos with the installed program ffmpeg, which gets the decoded frames as its input and
 * writes into a private folder beside the target. The bytes are not promised to be the same on
 * every machine. Transparent pixels are composited over black. A last column or row is repeated if
 * the size is odd, because the colors of videos are stored for 2 x 2 pixels. Immutable.
 *
 * @param program the installed program
 * @param format a video
 * @param encoder the program's encoder
 */
record VideoWriter(ExternalProgram program, AnimationFormat format, Encoder encoder)
    implements AnimationWriter {
  /** The environment variable with the path of the program. */
  private static final String VARIABLE = "LUMBRE_FFMPEG";

  private static final Duration MOST_AT_FIRST = Duration.ofMinutes(10);
  private static final Duration MOST_PER_FRAME = Duration.ofSeconds(10);

  /** The encoders of each video format, the best first. */
  private static final Map<AnimationFormat, List<Encoder>> ENCODERS =
      Map.of(
          AnimationFormat.MP4,
          List.of(
              new Encoder("libx264", 16384, "-crf", "17", "-movflags", "+faststart"),
              new Encoder("mpeg4", 8190, "-q:v", "2", "-movflags", "+faststart")),
          AnimationFormat.WEBM,
          List.of(
              new Encoder("libvpx-vp9", 16384, "-crf", "20", "-b:v", "0", "-row-mt", "1"),
              new Encoder("libvpx", 16382, "-crf", "5", "-b:v", "50M")));

  /**
   * An encoder of the program.
   *
   * @param side the most pixels on a side with which it was seen to work
   * @param options for a quality at which a viewer sees no loss
   */
  private record Encoder(String name, int side, List<String> options) {
    Encoder(String name, int side, String... options) {
      this(name, side, List.of(options));
    }
  }

  /**
   * Returns a writer with an encoder that the installed program has.
   *
   * @param chosen path of the program or of its folder; if empty, the variable LUMBRE_FFMPEG states
   *     it, or else the program is sought in the folders of {@code PATH}
   * @throws IOException if the program is not found, fails, or lacks the encoders of the format
   * @throws InterruptedException if the thread is interrupted
   */
  static VideoWriter find(
      AnimationFormat format, Optional<Path> chosen, Map<String, String> environment)
      throws IOException, InterruptedException {
    ExternalProgram program =
        ExternalProgram.find("ffmpeg", chosen, VARIABLE, environment, "install it");
    List<Encoder> encoders = ENCODERS.get(format);
    String listed = program.run(List.of("-hide_banner", "-encoders"), ExternalProgram.Input.NONE);
    for (Encoder encoder : encoders) {
      if (listed.lines().anyMatch(line -> line.matches(" V\\S+ " + encoder.name + " .*"))) {
        return new VideoWriter(program, format, encoder);
      }
    }
    throw new IOException(
        "%s: cannot write %s: it lacks the encoders %s; install a build that has one of them"
            .formatted(
                program.path(),
                format.ending(),
                encoders.stream().map(Encoder::name).collect(Collectors.joining(" and "))));
  }

  @Override
  public void requireFits(int width, int height) {
    String what = "a video of the encoder " + encoder.name;
    AnimationFormat.requireFits(what, encoder.side, even(width), even(height));
  }

  @Override
  public void write(AnimationFrames frames, Map<String, String> texts, OutputFile output)
      throws IOException, InterruptedException {
    Duration limit = MOST_AT_FIRST.plus(MOST_PER_FRAME.multipliedBy(frames.count()));
    try (PrivateFolder folder = PrivateFolder.beside(output.target())) {
      Path video = folder.path().resolve("video" + format.ending());
      program.within(limit).run(arguments(frames, video), out -> writeFrames(frames, out));
      requireVideo(video);
      AnimationFormat.commit(
          output,
          out -> {
            try (InputStream in = Files.newInputStream(video, LinkOption.NOFOLLOW_LINKS)) {
              in.transferTo(out);
            }
          });
    }
  }

  private void requireVideo(Path video) throws IOException {
    try {
      if (PrivateFolder.size(video) > 0) {
        return;
      }
    } catch (IOException e) {
      throw new IOException(program.path() + ": left no video: " + e.getMessage(), e);
    }
    throw new IOException(program.path() + ": left no video: an empty file");
  }

  private List<String> arguments(AnimationFrames frames, Path video) {
    String size = even(frames.width()) + "x" + even(frames.height());
    List<String> arguments = new ArrayList<>(List.of("-hide_banner", "-nostdin", "-v", "error"));
    // Without it, the program reports success when the disk is full.
    arguments.add("-xerror");
    arguments.addAll(List.of("-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size", size));
    FrameRate rate = frames.rate();
    arguments.addAll(List.of("-framerate", rate.frames() + "/" + rate.seconds(), "-i", "pipe:0"));
    arguments.addAll(List.of("-c:v", encoder.name));
    arguments.addAll(encoder.options);
    // The primaries and white of sRGB are those of BT.709; its curve has the name of its standard.
    arguments.addAll(
        List.of(
            "-vf",
            "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int",
            "-pix_fmt",
            "yuv420p"));
    arguments.addAll(List.of("-colorspace", "bt709", "-color_primaries", "bt709"));
    arguments.addAll(List.of("-color_trc", "iec61966-2-1", "-color_range", "tv"));
    arguments.addAll(List.of("-f", format.ending().substring(1), "-y", video.toString()));
    return arguments;
  }

  private static int even(int size) {
    return size + size % 2;
  }

  private static void writeFrames(AnimationFrames frames, OutputStream out) throws IOException {
    int width = frames.width();
    byte[] row = new byte[3 * even(width)];
    for (int frame = 0; frame < frames.count(); frame++) {
      int[] argb = frames.argb(frame);
      for (int y = 0; y < even(frames.height()); y++) {
        for (int x = 0; x < even(width); x++) {
          int pixel = argb[Math.min(y, frames.height() - 1) * width + Math.min(x, width - 1)];
          for (int channel = 0; channel < 3; channel++) {
            int value = pixel >> 16 - Byte.SIZE * channel & 0xff;
            row[3 * x + channel] = (byte) overBlack(value, pixel >>> 24);
          }
        }
        out.write(row);
      }
    }
  }

  private static int overBlack(int value, int alpha) {
    return alpha == 0xff ? value : Srgb.toByte(Srgb.fromByte(value) * alpha / 0xff);
  }
}
