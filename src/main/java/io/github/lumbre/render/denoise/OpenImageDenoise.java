package io.github.lumbre.render.denoise;

import io.github.lumbre.base.file.ExternalProgram;
import io.github.lumbre.base.file.PrivateFolder;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Denoises with the program {@code oidnDenoise} of Intel Open Image Denoise, as a process of its
 * own: a crash of the program does not end this one. Its results are not promised to be the same on
 * every machine.
 *
 * <p>The guides are denoised first, then the picture with them ({@code --clean_aux}), as the
 * program's documentation advises for the best result. Immutable.
 */
public final class OpenImageDenoise {
  /** The environment variable with the path of the program. */
  public static final String VARIABLE = "LUMBRE_OIDN";

  private static final String PROGRAM = "oidnDenoise";
  private static final Pattern VERSION = Pattern.compile("version=([0-9.]{1,20})");

  /** The header of a PFM file has three lines. */
  private static final int MOST_HEADER_BYTES = 1024;

  private final ExternalProgram program;
  private final int threads;

  private OpenImageDenoise(ExternalProgram program, int threads) {
    this.program = program;
    this.threads = threads;
  }

  /**
   * Returns the denoiser of an installed program.
   *
   * @param chosen path of the program or of its folder; if empty, the variable {@link #VARIABLE}
   *     tells it, or else the program is sought in the folders of {@code PATH}
   * @param environment the environment variables, such as {@link System#getenv()}
   * @throws DenoiseException if the program is not found; says how to get it
   */
  public static OpenImageDenoise find(Optional<Path> chosen, Map<String, String> environment)
      throws DenoiseException {
    String advice = "'pip install pyoidn' brings it, in the package's folder oidn/bin";
    try {
      return new OpenImageDenoise(
          ExternalProgram.find(PROGRAM, chosen, VARIABLE, environment, advice), 0);
    } catch (IOException e) {
      throw new DenoiseException(e.getMessage(), e);
    }
  }

  /** Returns a denoiser that ends each run of the program after this time; 10 minutes at first. */
  public OpenImageDenoise within(Duration each) {
    return new OpenImageDenoise(program.within(each), threads);
  }

  /** Returns a denoiser with this number of threads; 0 leaves the choice to the program. */
  public OpenImageDenoise withThreads(int count) {
    return new OpenImageDenoise(program, count);
  }

  /** Returns the path of the program. */
  public Path program() {
    return program.path();
  }

  /**
   * Denoises a picture. Its noise need not be known; guides are used if there are any.
   *
   * @throws DenoiseException if the program fails, takes too long, or answers nonsense
   * @throws InterruptedException if the thread is interrupted; the program is ended
   */
  public Denoised denoise(NoisyPicture noisy) throws DenoiseException, InterruptedException {
    try (PrivateFolder folder = PrivateFolder.temporary()) {
      return denoise(noisy, folder.path());
    } catch (IOException e) {
      throw new DenoiseException(program.path() + ": its files failed: " + e.getMessage(), e);
    }
  }

  private Denoised denoise(NoisyPicture noisy, Path folder)
      throws IOException, DenoiseException, InterruptedException {
    List<String> guides = new ArrayList<>();
    if (noisy.albedo().isPresent()) {
      guides.addAll(List.of("--alb", clean("--alb", noisy, noisy.albedo().get(), folder)));
    }
    // The program uses normals only beside an albedo.
    if (noisy.albedo().isPresent() && noisy.normal().isPresent()) {
      guides.addAll(List.of("--nrm", clean("--nrm", noisy, noisy.normal().get(), folder)));
    }
    if (!guides.isEmpty()) {
      guides.add("--clean_aux");
    }
    Path input = write(noisy, noisy.light(), folder.resolve("color.pfm"));
    Path output = folder.resolve("denoised.pfm");
    List<String> arguments = new ArrayList<>(List.of("--hdr", input.toString()));
    arguments.addAll(guides);
    String said = run(arguments, output);
    float[] light = result(noisy, output).rgb();
    Matcher version = VERSION.matcher(said);
    String name = "Open Image Denoise" + (version.find() ? " " + version.group(1) : "");
    OptionalDouble before = Denoised.noise(noisy, light);
    return Denoised.of(noisy, light, name, before, OptionalDouble.empty());
  }

  /** Denoises a guide and returns the file of the result. */
  private String clean(String flag, NoisyPicture noisy, NoisyPicture.Halves guide, Path folder)
      throws IOException, DenoiseException, InterruptedException {
    Path input = write(noisy, guide, folder.resolve("guide" + flag + ".pfm"));
    Path output = folder.resolve("clean" + flag + ".pfm");
    run(List.of(flag, input.toString()), output);
    result(noisy, output);
    return output.toString();
  }

  private static Path write(NoisyPicture noisy, NoisyPicture.Halves values, Path file)
      throws IOException {
    ImageWriter.write(new Image(noisy.width(), noisy.height(), values.mean(), new float[0]), file);
    return file;
  }

  /** Runs the program and returns its output. */
  private String run(List<String> arguments, Path output)
      throws DenoiseException, InterruptedException {
    List<String> command = new ArrayList<>(arguments);
    command.addAll(List.of("-o", output.toString()));
    if (threads > 0) {
      command.addAll(List.of("--threads", String.valueOf(threads)));
    }
    try {
      return program.run(command, ExternalProgram.Input.NONE);
    } catch (IOException e) {
      throw new DenoiseException(e.getMessage(), e);
    }
  }

  private Image result(NoisyPicture noisy, Path output) throws DenoiseException {
    Image image;
    try {
      long size = PrivateFolder.size(output);
      long most = MOST_HEADER_BYTES + 3L * Float.BYTES * noisy.width() * noisy.height();
      if (size > most) {
        throw new IOException("a file of " + size + " bytes, expected at most " + most);
      }
      image = LinearReader.read(output);
    } catch (IOException e) {
      throw new DenoiseException(
          program.path() + ": left no readable picture: " + e.getMessage(), e);
    }
    if (image.width() != noisy.width() || image.height() != noisy.height()) {
      throw new DenoiseException(
          "%s: expected a picture of %dx%d, found %dx%d"
              .formatted(
                  program.path(), noisy.width(), noisy.height(), image.width(), image.height()));
    }
    for (float value : image.rgb()) {
      if (!Float.isFinite(value)) {
        throw new DenoiseException(program.path() + ": expected finite pixels, found " + value);
      }
    }
    return image;
  }
}
