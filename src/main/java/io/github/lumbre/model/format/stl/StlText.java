package io.github.lumbre.model.format.stl;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Reads the solids of an STL text, in any letter case and with any line breaks. Not reusable. */
final class StlText {
  private final TextScanner scanner;
  private final Warnings warnings;
  private final List<StlSolid> solids = new ArrayList<>();

  private StlText(byte[] text, Warnings warnings) {
    scanner = TextScanner.plain(text);
    this.warnings = warnings;
  }

  /** Returns whether a file begins like a text. */
  static boolean startsIn(byte[] file) {
    TextScanner start = TextScanner.plain(file);
    return start.nextWordOfText() && start.word().equalsIgnoreCase("solid");
  }

  static List<StlSolid> read(byte[] text, Warnings warnings) throws ModelFormatException {
    StlText reader = new StlText(text, warnings);
    while (reader.scanner.nextWordOfText()) {
      reader.requireWord("solid");
      reader.readSolid();
    }
    return reader.solids;
  }

  private void readSolid() throws ModelFormatException {
    scanner.require("solids", ModelLimits.MAX_PARTS, solids.size() + 1);
    String location = scanner.location();
    StlSolid solid = new StlSolid(scanner.remainingWords(), location, 4);
    solids.add(solid);
    double[] facet = new double[12];
    while (nextIsFacet()) {
      readFacet(facet);
      solid.add(facet);
    }
    scanner.remainingWords();
  }

  private boolean nextIsFacet() throws ModelFormatException {
    if (!scanner.nextWordOfText()) {
      warnings.add(scanner.location(), "expected \"endsolid\", found the end of the file");
      return false;
    }
    if (wordIs("endsolid")) {
      return false;
    }
    requireWord("facet");
    return true;
  }

  private void readFacet(double[] facet) throws ModelFormatException {
    require("normal");
    for (int i = 0; i < 3; i++) {
      facet[i] = normalComponent();
    }
    require("outer");
    require("loop");
    for (int i = 0; i < 3; i++) {
      require("vertex");
      for (int k = 0; k < 3; k++) {
        nextWord("a number");
        facet[3 + 3 * i + k] = scanner.numberOrNan();
      }
    }
    require("endloop");
    require("endfacet");
  }

  /** Returns a number, or 0 for words such as "nan", which tools write for flat triangles. */
  private double normalComponent() throws ModelFormatException {
    nextWord("a number");
    try {
      return scanner.number();
    } catch (ModelFormatException e) {
      if (scanner.word().toLowerCase(Locale.ROOT).contains("n")) {
        return 0;
      }
      throw e;
    }
  }

  private void require(String expected) throws ModelFormatException {
    nextWord('"' + expected + '"');
    requireWord(expected);
  }

  private void requireWord(String expected) throws ModelFormatException {
    if (!wordIs(expected)) {
      throw scanner.error(
          "expected \"" + expected + "\", found " + PrintableText.quoted(scanner.word()));
    }
  }

  private void nextWord(String expected) throws ModelFormatException {
    if (!scanner.nextWordOfText()) {
      throw scanner.error("expected " + expected + ", found the end of the file");
    }
  }

  private boolean wordIs(String expected) {
    return scanner.wordIs(expected) || scanner.word().equalsIgnoreCase(expected);
  }
}
