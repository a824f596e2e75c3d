package io.github.lumbre.model;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelTexture.Wrap;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Reads the statements of a material library: those of Wavefront, and the extension of 2013 for
 * physically based materials. Keys are compared without regard to case. Not reusable.
 */
final class MtlReader {
  private static final int MAX_MATERIALS = 100_000;

  private static final Set<String> COLORS = Set.of("kd", "ks", "ke", "tf");
  private static final Set<String> NUMBERS =
      Set.of("ns", "d", "tr", "ni", "illum", "pr", "pm", "pc", "pcr", "ps");
  private static final Set<String> MAPS =
      Set.of(
          "map_kd",
          "map_ks",
          "map_ke",
          "map_d",
          "map_bump",
          "bump",
          "norm",
          "map_pr",
          "map_pm",
          "map_ps");

  /** Keys without an effect on light transport here: ambient light, sharpness, anisotropy. */
  private static final Set<String> SILENT =
      Set.of("ka", "km", "map_ka", "sharpness", "map_aat", "aniso", "anisor");

  /** Options whose number of values is fixed, and which have no effect. */
  private static final Set<String> IGNORED_OPTIONS = Set.of("-blendu", "-blendv", "-cc", "-type");

  private final TextScanner scanner;
  private final String file;
  private final Warnings warnings;
  private final List<MtlMaterial> materials = new ArrayList<>();

  private MtlReader(byte[] text, String file, Warnings warnings) {
    scanner = new TextScanner(text, PrintableText.shortened(file));
    this.file = file;
    this.warnings = warnings;
  }

  /**
   * Returns the materials of a library in their order.
   *
   * @param file name of the library
   */
  static List<MtlMaterial> read(byte[] text, String file, Warnings warnings)
      throws ModelFormatException {
    MtlReader reader = new MtlReader(text, file, warnings);
    while (reader.scanner.hasMore()) {
      if (reader.scanner.nextWord()) {
        reader.readLine();
      }
      reader.scanner.endLine();
    }
    return reader.materials;
  }

  private void readLine() throws ModelFormatException {
    String key = scanner.word().toLowerCase(Locale.ROOT);
    if (key.equals("newmtl")) {
      if (materials.size() == MAX_MATERIALS) {
        throw scanner.tooLarge("expected at most " + MAX_MATERIALS + " materials, found more");
      }
      String location = scanner.location();
      materials.add(new MtlMaterial(scanner.remainingWords(), location));
    } else if (materials.isEmpty()) {
      warn(" before", "ignored statements before the first newmtl");
    } else {
      readStatement(key, materials.get(materials.size() - 1));
    }
  }

  private void readStatement(String key, MtlMaterial material) throws ModelFormatException {
    if (COLORS.contains(key)) {
      readColor(key, material);
    } else if (NUMBERS.contains(key)) {
      boolean isHalo = scanner.nextWord() && scanner.wordIs("-halo");
      if (isHalo) {
        warn("-halo", "ignored the option -halo");
      }
      material.put(key, isHalo ? scanner.nextNumber() : currentNumber());
    } else if (MAPS.contains(key)) {
      material.put(key, readMap());
    } else if (!SILENT.contains(key)) {
      warn(key, "ignored the unknown key " + PrintableText.quoted(scanner.word()));
    }
  }

  private double currentNumber() throws ModelFormatException {
    if (scanner.word().isEmpty()) {
      throw scanner.error("expected a number, found the end of the line");
    }
    return scanner.number();
  }

  /** Reads one number for gray, or three. */
  private void readColor(String key, MtlMaterial material) throws ModelFormatException {
    scanner.nextWord();
    if (scanner.wordIs("spectral") || scanner.wordIs("xyz")) {
      warn(key + scanner.word(), "ignored a color of the kind " + scanner.word());
      return;
    }
    double r = currentNumber();
    if (!scanner.nextWord()) {
      material.put(key, color(r, r, r));
      return;
    }
    double g = scanner.number();
    material.put(key, color(r, g, scanner.nextNumber()));
  }

  private Rgb color(double r, double g, double b) {
    if (Math.min(r, Math.min(g, b)) < 0) {
      warn(" negative", "replaced a negative color component by 0");
    }
    return new Rgb(Math.max(0, r), Math.max(0, g), Math.max(0, b));
  }

  private MtlMap readMap() throws ModelFormatException {
    String location = scanner.location();
    double[] scale = {1, 1, 1};
    double[] offset = {0, 0, 0};
    double bumpScale = 1;
    int channel = -1;
    Wrap wrap = Wrap.REPEAT;
    boolean hasWord = scanner.nextWord();
    while (hasWord && scanner.word().matches("-[A-Za-z]+")) {
      String option = scanner.word();
      switch (option) {
        case "-s" -> hasWord = readVector(scale);
        case "-o" -> hasWord = readVector(offset);
        case "-t" -> {
          warnOption(option);
          hasWord = readVector(new double[3]);
        }
        case "-clamp" -> {
          wrap = requiredWord().equals("on") ? Wrap.CLAMP : Wrap.REPEAT;
          hasWord = scanner.nextWord();
        }
        case "-bm" -> {
          bumpScale = scanner.nextNumber();
          hasWord = scanner.nextWord();
        }
        case "-imfchan" -> {
          channel = "rgbm".indexOf(requiredWord());
          hasWord = scanner.nextWord();
        }
        case "-mm" -> {
          boolean changes = scanner.nextNumber() != 0;
          changes |= scanner.nextNumber() != 1;
          if (changes) {
            warnOption(option);
          }
          hasWord = scanner.nextWord();
        }
        case "-boost", "-texres" -> {
          warnOption(option);
          requiredWord();
          hasWord = scanner.nextWord();
        }
        default -> {
          if (!IGNORED_OPTIONS.contains(option)) {
            throw scanner.error(
                "expected an option such as -s or a file, found " + PrintableText.quoted(option));
          }
          requiredWord();
          hasWord = scanner.nextWord();
        }
      }
    }
    if (!hasWord) {
      throw scanner.error("expected the name of a picture, found the end of the line");
    }
    String rest = scanner.name();
    String more = scanner.remainingWords();
    return new MtlMap(
        location,
        besideLibrary(more.isEmpty() ? rest : rest + " " + more),
        channel,
        bumpScale,
        wrap,
        new UvTransform(scale[0], 0, offset[0], 0, scale[1], offset[1]));
  }

  /** Reads one to three numbers, and moves to the next word; returns false if there is none. */
  private boolean readVector(double[] vector) throws ModelFormatException {
    vector[0] = scanner.nextNumber();
    int count = 1;
    boolean hasWord = scanner.nextWord();
    while (hasWord && count < 3 && scanner.word().matches("[-+.]?[0-9][-+.eE0-9]*")) {
      vector[count++] = scanner.number();
      hasWord = scanner.nextWord();
    }
    return hasWord;
  }

  private String requiredWord() throws ModelFormatException {
    if (!scanner.nextWord()) {
      throw scanner.error("expected the value of an option, found the end of the line");
    }
    return scanner.word();
  }

  private String besideLibrary(String picture) {
    return file.substring(0, file.lastIndexOf('/') + 1) + MtlMap.portable(picture);
  }

  private void warnOption(String option) {
    warn(option, "ignored the option " + option);
  }

  private void warn(String key, String message) {
    warnings.once(file + "/" + key, scanner.location(), message);
  }
}
