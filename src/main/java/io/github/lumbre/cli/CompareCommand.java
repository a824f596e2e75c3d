package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.JsonText;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.run.LayerInput;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.compare.internal.ErrorMap;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre compare}: measures the error of a picture against a reference. */
@Command(
    name = "compare",
    header = "Measure the error of a picture against a reference.",
    description =
        "Read PNG, JPEG and the other formats of textures, PFM, Radiance HDR and OpenEXR. Pictures"
            + " are compared in linear light: those of textures are decoded from sRGB. Alpha is"
            + " ignored; the colors of OpenEXR are those in the file, multiplied by alpha.",
    footer = {
      "",
      "Metrics: rmse, relmse (mean of (x-r)^2/(r^2+0.01)), bias (mean of x-r), p99.9 and max of"
          + " the absolute error, ssim (1: identical), flip (0: identical; LDR-FLIP at 67 pixels"
          + " per degree).",
      "",
      "Examples:",
      "  lumbre compare draft.exr reference.exr",
      "  lumbre compare a.pfm b.pfm --tolerance rmse=0.01,flip=0.05 --error-map where.png"
    })
@Exits(
    value = {
      ExitCode.OK, ExitCode.DIFFERENT, ExitCode.ABSENT, ExitCode.ASSET, ExitCode.LIMIT,
      ExitCode.OUTPUT
    },
    different = "a metric is outside its tolerance")
final class CompareCommand extends Subcommand {
  private static final String LIKENESS = "ssim";

  /** The names of all metrics. */
  private static final List<String> NAMES =
      List.copyOf(new PictureError(0, 0, 0, 0, 0, 0, 0).byName().keySet());

  @Parameters(index = "0", paramLabel = "PICTURE", description = "Picture to compare.")
  private Path picture;

  @Parameters(
      index = "1",
      paramLabel = "REFERENCE",
      description = "Reference picture of the same size.")
  private Path reference;

  @Option(
      names = "--tolerance",
      paramLabel = "NAME=LIMIT",
      split = ",",
      description =
          "Exit with code 1 if a metric is above its limit (ssim: below; bias: in absolute"
              + " value).")
  private Map<String, Double> tolerance = new LinkedHashMap<>();

  @Option(
      names = "--layer",
      paramLabel = "NAME",
      description =
          "Compare this layer of two OpenEXR or checkpoint files, such as depth or lights.key.")
  private Optional<String> layer = Optional.empty();

  @Option(
      names = "--error-map",
      paramLabel = "OUT.png",
      description =
          "Write a picture of each pixel's relative error: black up to 0.001, purple 0.01, orange"
              + " 0.1, pale yellow from 1.")
  private Optional<Path> errorMap = Optional.empty();

  @Option(names = "--json", description = "Print the metrics as a JSON object.")
  private boolean json;

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws TaskException {
    validate();
    OutputGuard guard =
        overwrite.guard().reads(picture, "the picture").reads(reference, "the reference");
    errorMap.ifPresent(map -> guard.writes("--error-map", map, OutputContent.PICTURE));
    guard.check();
    Image a = layer.isPresent() ? readLayer(picture, layer.get()) : read(picture);
    Image b = layer.isPresent() ? readLayer(reference, layer.get()) : read(reference);
    if (a.width() != b.width() || a.height() != b.height()) {
      throw ExitCode.USAGE.failure(
          "%s has %dx%d pixels, %s has %dx%d: expected pictures of the same size"
              .formatted(picture, a.width(), a.height(), reference, b.width(), b.height()));
    }
    PictureError error = PictureError.of(a, b);
    if (errorMap.isPresent()) {
      Image map = ErrorMap.of(a, b);
      Failures.written(
          () -> {
            ImageWriter.write(map, errorMap.get());
            return map;
          });
    }
    Messages out = out();
    List<String> beyond = beyond(error);
    if (json) {
      spec.commandLine().getOut().println(JsonText.pretty(values(error, beyond)));
      spec.commandLine().getOut().flush();
    } else {
      out.line(
          "%s against %s, %dx%d pixels%s"
              .formatted(
                  picture,
                  reference,
                  a.width(),
                  a.height(),
                  error.largest() == 0 ? ": no difference" : ", in linear light"));
      error.byName().forEach((name, value) -> out.line(line(name, value, beyond)));
    }
    return beyond.isEmpty() ? ExitCode.OK : ExitCode.DIFFERENT;
  }

  private void validate() {
    tolerance.forEach(
        (name, limit) -> {
          require(
              NAMES.contains(name),
              "--tolerance: expected one of %s, found '%s'"
                  .formatted(String.join(", ", NAMES), name));
          require(limit >= 0, "--tolerance: expected numbers of at least 0, found " + plain(limit));
        });
    errorMap.ifPresent(
        file ->
            require(
                ImageFormat.of(file).equals(Optional.of(ImageFormat.PNG)),
                "--error-map: expected a name that ends in .png, found " + file));
  }

  private Image readLayer(Path file, String name) throws TaskException {
    Messages errors = errors();
    return finite(LayerInput.layer(LayerInput.read(file, errors), name, file).toImage(), file);
  }

  private static Image finite(Image image, Path file) throws TaskException {
    for (float value : image.rgb()) {
      if (!Float.isFinite(value)) {
        throw ExitCode.ASSET.failure(
            file + ": has NaN or infinite values, so no metric can be computed");
      }
    }
    return image;
  }

  private static Image read(Path file) throws TaskException {
    try {
      return finite(LinearReader.open(file).light(), file);
    } catch (IOException e) {
      throw LayerInput.failure(file, e);
    }
  }

  private List<String> beyond(PictureError error) {
    Map<String, Double> figures = error.byName();
    return tolerance.entrySet().stream()
        .filter(limit -> !isWithin(limit.getKey(), figures.get(limit.getKey()), limit.getValue()))
        .map(Map.Entry::getKey)
        .toList();
  }

  private static boolean isWithin(String name, double value, double limit) {
    return name.equals(LIKENESS) ? value >= limit : Math.abs(value) <= limit;
  }

  private String line(String name, double value, List<String> beyond) {
    String text = String.format(Locale.ROOT, "%-7s %-12.6g %s", name, value, meaning(name, value));
    if (!tolerance.containsKey(name)) {
      return text;
    }
    String verdict = beyond.contains(name) ? "outside" : "within";
    return text + "; " + verdict + " the tolerance of " + plain(tolerance.get(name));
  }

  private static String meaning(String name, double value) {
    return switch (name) {
      case "rmse" -> "root mean square of the difference";
      case "relmse" ->
          "mean square relative to the reference; its root, %s, is comparable to a render's noise"
              .formatted(Numbers.percent(Math.sqrt(value)));
      case "bias" ->
          "mean difference: "
              + (value == 0 ? "as bright as" : value > 0 ? "brighter than" : "darker than")
              + " the reference";
      case "p99.9" -> "99.9 % of the values differ by at most this";
      case "max" -> "largest difference";
      case "ssim" -> "structural similarity (1: identical)";
      case "flip" -> "difference that is seen when the pictures alternate (0: none, 1: largest)";
      default -> throw new AssertionError(name);
    };
  }

  /** Returns a number without exponent. */
  private static String plain(double number) {
    return Double.isFinite(number)
        ? BigDecimal.valueOf(number).stripTrailingZeros().toPlainString()
        : String.valueOf(number);
  }

  private Map<String, Object> values(PictureError error, List<String> beyond) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("picture", picture.toString());
    values.put("reference", reference.toString());
    values.putAll(error.byName());
    values.put("tolerance", tolerance);
    values.put("beyond", beyond);
    return values;
  }
}
