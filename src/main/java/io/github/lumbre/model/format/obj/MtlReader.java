package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Reads the statements of a material library by Wavefront, and of its extension of 2013 for
 * physically based materials. Keys are compared without regard to case. Not reusable.
 */
final class MtlReader {
  private static final int MAX_MATERIALS = 100_000;

  private static final Set<String> COLORS = Set.of("kd", "ks", "ke", "tf");

  /** Numbers and maps besides {@link MaterialParameter#mtl}. */
  private static final Set<String> NUMBERS = Set.of("ns", "d", "tr", "ni", "illum");

  private static final Set<String> MAPS =
      Set.of("map_kd", "map_ks", "map_ke", "map_d", "map_bump", "bump", "norm");

  /** Keys without an effect on light transport here: ambient light, sharpness, anisotropy. */
  private static final Set<String> SILENT =
      Set.of("ka", "km", "map_ka", "sharpness", "map_aat", "aniso", "anisor");

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
      scanner.require("materials", MAX_MATERIALS, materials.size() + 1);
      String location = scanner.location();
      materials.add(new MtlMaterial(scanner.remainingWords(), location));
    } else if (materials.isEmpty()) {
      warn(" before", "ignored statements before the first newmtl");
    } else {
      readIntact(key, materials.get(materials.size() - 1));
    }
  }

  /** Reads a statement; a wrong one is ignored with a warning. */
  private void readIntact(String key, MtlMaterial material) throws ModelFormatException {
    String shown = PrintableText.shortened(scanner.word());
    try {
      readStatement(key, material);
    } catch (ModelFormatException e) {
      if (e.kind() != Kind.MALFORMED) {
        throw e;
      }
      warnings.add(
          "ignored a wrong statement of a material",
          e.location(),
          "ignored a wrong " + shown + ": " + e.detail());
    }
  }

  private void readStatement(String key, MtlMaterial material) throws ModelFormatException {
    if (COLORS.contains(key)) {
      readColor(key, material);
    } else if (NUMBERS.contains(key) || isParameter(key)) {
      boolean isHalo = scanner.nextWord() && scanner.wordIs("-halo");
      if (isHalo) {
        warnOption("-halo");
      }
      material.put(key, isHalo ? scanner.nextNumber() : currentNumber());
    } else if (MAPS.contains(key) || key.startsWith("map_") && isParameter(key.substring(4))) {
      String before = file.substring(0, file.lastIndexOf('/') + 1);
      material.put(key, new MtlMapReader(scanner, this::warnOption).read(before));
    } else if (!SILENT.contains(key)) {
      warn(key, "ignored the unknown key " + PrintableText.quoted(scanner.word()));
    }
  }

  private static boolean isParameter(String key) {
    return MaterialParameter.all().stream().anyMatch(p -> p.mtl().equals(key));
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
      material.put(key, new Rgb(r, r, r));
      return;
    }
    double g = scanner.number();
    material.put(key, new Rgb(r, g, scanner.nextNumber()));
  }


  private void warnOption(String option) {
    warn(option, "ignored the option " + option);
  }

  private void warn(String key, String message) {
    warnings.once(file + "/" + key, scanner.location(), message);
  }
}
