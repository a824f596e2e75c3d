package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.UvTransform;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/** Reads the options and the file name of one texture statement. Not reusable. */
final class MtlMapReader {
  /** Options with one value that do not change colors or positions. */
  private static final Set<String> IGNORED = Set.of("-blendu", "-blendv", "-cc", "-type");

  private static final Pattern OPTION = Pattern.compile("-[A-Za-z]+");
  private static final Pattern NUMBER = Pattern.compile("[-+.]?[0-9][-+.eE0-9]*");

  private final TextScanner scanner;
  private final Consumer<String> ignored;
  private final String location;
  private final double[] scale = {1, 1, 1};
  private final double[] offset = {0, 0, 0};
  private double bumpScale = 1;
  private int channel = -1;
  private Wrap wrap = Wrap.REPEAT;

  /** Whether the scanner is at a word that has not been used. */
  private boolean hasWord;

  /**
   * @param ignored receives options that are not supported
   */
  MtlMapReader(TextScanner scanner, Consumer<String> ignored) {
    this.scanner = scanner;
    this.ignored = ignored;
    location = scanner.location();
  }

  /**
   * Reads the rest of the line.
   *
   * @param folder of the library, with / at its end; empty for the folder of the model
   */
  MtlMap read(String folder) throws ModelFormatException {
    hasWord = scanner.nextWord();
    while (hasWord && OPTION.matcher(scanner.word()).matches()) {
      readOption(scanner.word());
    }
    if (!hasWord) {
      throw scanner.error("expected the name of a picture, found the end of the line");
    }
    String name = scanner.name();
    String rest = scanner.remainingWords();
    return new MtlMap(
        location,
        folder + MtlMap.portable(rest.isEmpty() ? name : name + " " + rest),
        channel,
        bumpScale,
        wrap,
        new UvTransform(scale[0], 0, offset[0], 0, scale[1], offset[1]));
  }

  /** Reads the values of an option, and moves to the word after them. */
  private void readOption(String option) throws ModelFormatException {
    switch (option) {
      case "-s" -> {
        readVector(scale);
        return;
      }
      case "-o" -> {
        readVector(offset);
        return;
      }
      case "-t" -> {
        ignored.accept(option);
        readVector(new double[3]);
        return;
      }
      case "-clamp" -> wrap = nextWord().equals("on") ? Wrap.CLAMP : Wrap.REPEAT;
      case "-bm" -> bumpScale = scanner.nextNumber();
      case "-imfchan" -> channel = "rgbm".indexOf(nextWord());
      case "-mm" -> {
        double base = scanner.nextNumber();
        double gain = scanner.nextNumber();
        if (base != 0 || gain != 1) {
          ignored.accept(option);
        }
      }
      case "-boost", "-texres" -> {
        ignored.accept(option);
        nextWord();
      }
      default -> {
        if (!IGNORED.contains(option)) {
          ignored.accept(PrintableText.shortened(option));
          skipUnknownValue();
          return;
        }
        nextWord();
      }
    }
    hasWord = scanner.nextWord();
  }

  /** Skips the value of an unknown option, unless the line has only one more word: the file. */
  private void skipUnknownValue() throws ModelFormatException {
    hasWord = scanner.nextWord();
    if (hasWord && !OPTION.matcher(scanner.word()).matches() && scanner.hasMoreWords()) {
      hasWord = scanner.nextWord();
    }
  }

  /** Reads one to three numbers, and moves to the next word. */
  private void readVector(double[] vector) throws ModelFormatException {
    vector[0] = scanner.nextNumber();
    int count = 1;
    hasWord = scanner.nextWord();
    while (hasWord && count < 3 && NUMBER.matcher(scanner.word()).matches()) {
      vector[count++] = scanner.number();
      hasWord = scanner.nextWord();
    }
  }

  private String nextWord() throws ModelFormatException {
    if (!scanner.nextWord()) {
      throw scanner.error("expected the value of an option, found the end of the line");
    }
    return scanner.word();
  }
}
