package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.output.LayerFiles;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.run.LayerInput;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.Cryptomatte;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre layers}: lists the layers of a file, and writes them as PNG. */
@Command(
    name = "layers",
    header = "List the layers of an OpenEXR or checkpoint file, or write PNGs.",
    description =
        "Layers are recorded with 'lumbre render --layers'. Mattes of objects and materials are"
            + " listed with the share of the picture that each covers.",
    footer = {
      "",
      "PNG files: normals as n/2 + 1/2, colors with the sRGB curve, masks of objects with 255 for"
          + " a covered pixel; other layers with 16 bits, whose range the metadata state as Low"
          + " and High.",
      "",
      "Examples:",
      "  lumbre layers picture.exr",
      "  lumbre layers picture.exr --layer depth --png folder"
    })
@Exits({
  ExitCode.OK, ExitCode.ABSENT, ExitCode.FILM, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.OUTPUT
})
final class LayersCommand extends Subcommand {
  private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();

  @Parameters(paramLabel = "FILE", description = "OpenEXR file (.exr) or checkpoint file.")
  private Path file;

  @Option(
      names = "--layer",
      paramLabel = "NAME",
      description = "Only this layer, such as depth or CryptoObject. May be repeated.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = "--png",
      paramLabel = "FOLDER",
      description = "Write each layer as PNG files in this folder.")
  private Optional<Path> folder = Optional.empty();

  @Option(names = "--json", description = "Print the layers as a JSON object.")
  private boolean json;

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws TaskException {
    Messages errors = errors();
    LayeredImage image = LayerInput.read(file, errors);
    List<Cryptomatte> all = mattes(image);
    List<ImageLayer> layers = wanted(image, all);
    List<Cryptomatte> mattes = wanted(all);
    if (folder.isPresent()) {
      write(layers, mattes, folder.get());
    } else if (json) {
      spec.commandLine().getOut().println(GSON.toJson(values(image, layers, mattes)));
      spec.commandLine().getOut().flush();
    } else {
      print(layers, mattes, out());
    }
    return ExitCode.OK;
  }

  private List<Cryptomatte> mattes(LayeredImage image) throws TaskException {
    try {
      return Cryptomatte.in(image);
    } catch (ImageFormatException e) {
      throw ExitCode.ASSET.failure(file + ": " + e.getMessage(), e);
    }
  }

  private List<Cryptomatte> wanted(List<Cryptomatte> mattes) {
    return mattes.stream()
        .filter(matte -> names.isEmpty() || names.contains(matte.type()))
        .toList();
  }

  /** Returns the wanted layers that are not part of a matte. */
  private List<ImageLayer> wanted(LayeredImage image, List<Cryptomatte> mattes)
      throws TaskException {
    if (names.isEmpty()) {
      return image.layers().stream()
          .filter(layer -> mattes.stream().noneMatch(matte -> matte.layers().contains(layer)))
          .toList();
    }
    List<ImageLayer> layers = new ArrayList<>();
    for (String name : names) {
      if (mattes.stream().noneMatch(matte -> matte.type().equals(name))) {
        layers.add(LayerInput.layer(image, name, file, names(image, mattes)));
      }
    }
    return layers;
  }

  /** Returns the names that {@code --layer} takes: mattes instead of the layers they consist of. */
  private static List<String> names(LayeredImage image, List<Cryptomatte> mattes) {
    Stream<String> plain =
        image.layers().stream()
            .filter(layer -> mattes.stream().noneMatch(matte -> matte.layers().contains(layer)))
            .map(ImageLayer::name)
            .filter(name -> !name.isEmpty());
    return Stream.concat(plain, mattes.stream().map(Cryptomatte::type)).toList();
  }

  private void write(List<ImageLayer> layers, List<Cryptomatte> mattes, Path target)
      throws TaskException {
    LayerFiles files = new LayerFiles(target);
    layers.forEach(files::add);
    mattes.forEach(files::add);
    OutputGuard guard = overwrite.guard().reads(file, "the file");
    files.paths().forEach(path -> guard.writes("--png", path, OutputContent.PICTURE));
    guard.check();
    files.write();
    Messages out = out();
    files.paths().forEach(path -> out.line(path.toString()));
  }

  private static void print(List<ImageLayer> layers, List<Cryptomatte> mattes, Messages out) {
    for (ImageLayer layer : layers) {
      Range range = Range.of(layer);
      out.line(
          String.format(
                  Locale.ROOT,
                  "%-18s %-8s %-6s %s",
                  shown(layer),
                  Messages.printable(String.join(" ", layer.channels())),
                  layer.precision().name().toLowerCase(Locale.ROOT),
                  range.text())
              .stripTrailing());
    }
    for (Cryptomatte matte : mattes) {
      out.line(
          Messages.printable(matte.type()) + ": " + matte.ids().size() + " names, with coverage");
      shares(matte)
          .forEach(
              (name, share) ->
                  out.line(
                      String.format(
                          Locale.ROOT, "  %6.2f %%  %s", 100 * share, Messages.printable(name))));
    }
  }

  private static String shown(ImageLayer layer) {
    return layer.name().isEmpty() ? "(picture)" : Messages.printable(layer.name());
  }

  /** Returns the share of the picture that each item covers. */
  private static Map<String, Double> shares(Cryptomatte matte) {
    Map<String, Double> shares = new LinkedHashMap<>();
    for (String name : matte.ids().keySet()) {
      double sum = 0;
      float[] mask = matte.mask(name);
      for (float share : mask) {
        sum += share;
      }
      shares.put(name, sum / Math.max(1, mask.length));
    }
    return shares;
  }

  private static Map<String, Object> values(
      LayeredImage image, List<ImageLayer> layers, List<Cryptomatte> mattes) {
    List<Map<String, Object>> listed = new ArrayList<>();
    for (ImageLayer layer : layers) {
      Range range = Range.of(layer);
      Map<String, Object> values = new LinkedHashMap<>();
      values.put("name", layer.name());
      values.put("channels", layer.channels());
      values.put("precision", layer.precision().name().toLowerCase(Locale.ROOT));
      values.put("min", range.low());
      values.put("max", range.high());
      values.put("not_finite", range.notFinite());
      listed.add(values);
    }
    Map<String, Object> mattesByType = new LinkedHashMap<>();
    mattes.forEach(matte -> mattesByType.put(matte.type(), shares(matte)));
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("width", image.width());
    all.put("height", image.height());
    all.put("layers", listed);
    all.put("mattes", mattesByType);
    return all;
  }

  /**
   * The range of a layer's finite values; both 0 if it has none.
   *
   * @param notFinite number of NaN and infinite values
   */
  private record Range(double low, double high, int notFinite) {
    static Range of(ImageLayer layer) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      int notFinite = 0;
      for (float value : layer.values()) {
        if (Float.isFinite(value)) {
          low = Math.min(low, value);
          high = Math.max(high, value);
        } else {
          notFinite++;
        }
      }
      return low <= high ? new Range(low, high, notFinite) : new Range(0, 0, notFinite);
    }

    String text() {
      String values = String.format(Locale.ROOT, "%.6g to %.6g", low, high);
      return notFinite == 0 ? values : values + ", " + notFinite + " not finite";
    }
  }
}
