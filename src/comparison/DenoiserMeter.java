import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.denoise.OpenImageDenoise;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Measures pictures of checkpoint files before and after denoising. Arguments: a folder for the
 * denoised pictures, which are made where they are missing, the program oidnDenoise or -, the
 * checkpoint file of the reference or - (only denoise), then the files to denoise. The reference
 * must have other samples of the same scene and seed.
 *
 * <p>Prints a line of comma-separated values for each picture: file, engine, relMSE, FLIP, SSIM,
 * bias, predicted relMSE. The first line has the relMSE of the reference itself, as the halves of
 * its samples show it.
 */
final class DenoiserMeter {
  private final Path folder;
  private final String oidn;

  private DenoiserMeter(Path folder, String oidn) {
    this.folder = folder;
    this.oidn = oidn;
  }

  public static void main(String[] args) throws Exception {
    DenoiserMeter meter = new DenoiserMeter(Path.of(args[0]), args[1]);
    Files.createDirectories(meter.folder);
    Optional<Image> reference = Optional.empty();
    if (!args[2].equals("-")) {
      reference = Optional.of(overBlack(picture(args[2])));
      System.out.printf(
          Locale.ROOT, "%s,reference,%.6g,,,,%n", Path.of(args[2]).getFileName(), noise(args[2]));
    }
    for (int i = 3; i < args.length; i++) {
      meter.measure(args[i], reference);
    }
  }

  private void measure(String file, Optional<Image> reference) throws Exception {
    Path builtIn = result(file, "builtin.pfm");
    Path estimate = result(file, "builtin.txt");
    if (!Files.exists(estimate)) {
      Denoised denoised = BuiltInDenoiser.denoise(noisy(file), 2);
      ImageWriter.write(overBlack(denoised.image()), builtIn);
      double predicted = denoised.relativeError().getAsDouble();
      Files.writeString(estimate, String.valueOf(predicted * predicted));
    }
    Path other = result(file, "oidn.pfm");
    if (!oidn.equals("-") && !Files.exists(other)) {
      OpenImageDenoise program = OpenImageDenoise.find(Optional.of(Path.of(oidn)), Map.of());
      Image image = program.denoise(noisy(file)).image();
      ImageWriter.write(overBlack(image), other);
    }
    if (reference.isPresent()) {
      print(file, "noisy", PictureError.of(picture(file), reference.get()), "");
      PictureError error = PictureError.of(LinearReader.read(builtIn), reference.get());
      print(file, "builtin", error, Files.readString(estimate));
      if (Files.exists(other)) {
        print(file, "oidn", PictureError.of(LinearReader.read(other), reference.get()), "");
      }
    }
  }

  private Path result(String file, String ending) {
    return folder.resolve(Path.of(file).getFileName() + "." + ending);
  }

  private static NoisyPicture noisy(String file) throws IOException {
    return NoisyPicture.of(FilmFile.read(Path.of(file)).film());
  }

  private static Image picture(String file) throws IOException {
    return FilmFile.read(Path.of(file)).film().develop();
  }

  /** Returns the relMSE of a film's picture, by the difference of the halves of its samples. */
  private static double noise(String file) throws IOException {
    NoisyPicture.Halves light = noisy(file).light();
    double sum = 0;
    for (int i = 0; i < light.mean().length; i++) {
      double squared = (double) light.mean()[i] * light.mean()[i];
      sum += light.noise()[i] * (double) light.noise()[i] / (squared + PictureError.FLOOR);
    }
    return sum / light.mean().length;
  }

  private static Image overBlack(Image image) {
    double[] values = PictureError.seen(image);
    float[] rgb = new float[values.length];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) values[i];
    }
    return new Image(image.width(), image.height(), rgb, new float[0]);
  }

  private static void print(String file, String engine, PictureError error, String predicted) {
    System.out.printf(
        Locale.ROOT,
        "%s,%s,%.6g,%.6g,%.6g,%.6g,%s%n",
        Path.of(file).getFileName(),
        engine,
        error.relativeMse(),
        error.flip(),
        error.ssim(),
        error.bias(),
        predicted);
  }
}
