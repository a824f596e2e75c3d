package io.github.lumbre.model.format.ies;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads photometric files of lamps: IES LM-63 of 1986, 1991, 1995, 2002 and 2019, with type C
 * photometry. The size of the luminous opening, the power and the keywords do not count: the lamp
 * is a point. Mutable; confined to one thread.
 */
public final class IesReader {
  /** The largest number of vertical, and of horizontal, angles; a file has at most 361. */
  static final int MAX_ANGLES = 1024;

  /** The last line of the header, with or without blanks. */
  private static final Pattern TILT =
      Pattern.compile("TILT *= *(.*?) *", Pattern.CASE_INSENSITIVE);

  private static final String[] TYPES = {"C", "B", "A"};

  /** A flux above this multiple of the lamps' rated flux is a sign of a wrong file. */
  private static final double MAX_EFFICIENCY = 1.05;

  private final TextScanner scanner;
  private final Warnings warnings;

  /** Whether the third factor is that of the ballast with its lamp, as it was until 1995. */
  private boolean hasBallastLampFactor;

  private IesReader(TextScanner scanner, Warnings warnings) {
    this.scanner = scanner;
    this.warnings = warnings;
  }

  /**
   * Returns the profile of a lamp, with all factors of the file.
   *
   * @param file its bytes; texts are ISO 8859-1, and numbers are separated by blanks or commas
   * @param warnings receives what the file has and the profile lacks
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   */
  public static LightProfile read(byte[] file, Warnings warnings) throws ModelFormatException {
    byte[] text = file.clone();
    for (int i = 0; i < text.length; i++) {
      text[i] = text[i] == ',' ? (byte) ' ' : text[i];
    }
    return new IesReader(TextScanner.plain(text), warnings).profile(text.length);
  }

  private LightProfile profile(int length) throws ModelFormatException {
    readHeader();
    double lamps = next("the number of lamps");
    double lumens = next("the lumens of a lamp");
    double multiplier = atLeastZero("the multiplier");
    int verticalCount = count("vertical angles");
    int horizontalCount = count("horizontal angles");
    requireNumbers(verticalCount, horizontalCount, length - scanner.position());
    requireTypeC();
    for (String skipped : new String[] {"the units", "the width", "the length", "the height"}) {
      next(skipped);
    }
    double ballast = atLeastZero("the ballast factor");
    double ballastLamp = atLeastZero("the ballast-lamp factor");
    next("the input power");
    double[] vertical = angles("vertical", verticalCount, 180);
    HorizontalAngles turn = turn(angles("horizontal", horizontalCount, 360));
    double factor = multiplier * ballast * (hasBallastLampFactor ? ballastLamp : 1);
    double[] candela = candela(verticalCount, horizontalCount, factor);
    warnOfRest();
    LightProfile profile = new LightProfile(vertical, turn.angles(), turn.rows(), candela);
    warnOfFlux(lamps * lumens * factor, profile.flux());
    return profile;
  }

  /** Reads the lines to TILT=, and the table of tilts. */
  private void readHeader() throws ModelFormatException {
    String first = scanner.nextWord() ? scanner.word() : "";
    hasBallastLampFactor = !first.startsWith("IESNA:") && !first.startsWith("IES:");
    Matcher line = TILT.matcher(restOfLine(first));
    while (!line.matches()) {
      if (!scanner.hasMore()) {
        throw scanner.error("expected a line TILT=NONE of an IES file (LM-63), found its end");
      }
      scanner.endLine();
      line.reset(scanner.nextWord() ? restOfLine(scanner.word()) : "");
    }
    String tilt = line.group(1);
    String location = scanner.location();
    scanner.endLine();
    if (tilt.equalsIgnoreCase("NONE")) {
      return;
    }
    warnings.add(
        location,
        "the tilts are ignored, so that a tilted lamp is as bright as an upright one, found TILT="
            + PrintableText.quoted(tilt));
    if (tilt.equalsIgnoreCase("INCLUDE")) {
      next("the lamp's geometry");
      int pairs = count("tilts");
      for (int i = 0; i < 2 * pairs; i++) {
        next(i < pairs ? "a tilt" : "the factor of a tilt");
      }
    }
  }

  /** Returns the rest of a line with its first word, if that may state the tilt. */
  private String restOfLine(String word) {
    boolean mayBe = word.regionMatches(true, 0, "TILT", 0, 4);
    return mayBe ? word + " " + scanner.remainingWords() : "";
  }

  /** Checks that the rest of the file can have as many numbers as it should. */
  private void requireNumbers(int verticalCount, int horizontalCount, int bytes)
      throws ModelFormatException {
    long numbers = (long) verticalCount * horizontalCount + verticalCount + horizontalCount;
    // The shortest number is a digit with a blank.
    long most = bytes / 2 + 1;
    if (numbers > most) {
      throw scanner.error(
          "expected %s angles and candelas, found the end of the file after at most %s"
              .formatted(numbers, most));
    }
  }

  private void requireTypeC() throws ModelFormatException {
    double type = next("the photometric type");
    if (type == 1) {
      return;
    }
    if (type == 2 || type == 3) {
      throw Kind.UNSUPPORTED.at(
          scanner.location(),
          "expected type C photometry (1), found type "
              + TYPES[(int) type - 1]
              + "; ask for a file of type C, or convert it with a photometric editor");
    }
    throw expected("the photometric type 1, 2 or 3");
  }

  private HorizontalAngles turn(double[] angles) throws ModelFormatException {
    Optional<HorizontalAngles> turn = HorizontalAngles.of(angles);
    if (turn.isEmpty()) {
      throw expected("horizontal angles from 0 to 0, 90, 180 or 360, or from 90 to 270");
    }
    return turn.get();
  }

  private double[] candela(int verticalCount, int horizontalCount, double factor)
      throws ModelFormatException {
    double[] candela = new double[verticalCount * horizontalCount];
    for (int i = 0; i < candela.length; i++) {
      if (i % verticalCount == 0) {
        Interrupts.check();
      }
      candela[i] = factor * atLeastZero("candelas");
      if (!(candela[i] <= Float.MAX_VALUE)) {
        throw expected("fewer candelas, with all factors");
      }
    }
    return candela;
  }

  private double[] angles(String kind, int count, double largest) throws ModelFormatException {
    double[] angles = new double[count];
    for (int i = 0; i < count; i++) {
      angles[i] = next("a " + kind + " angle");
      if (!(angles[i] >= 0 && angles[i] <= largest)) {
        throw expected(
            "a %s angle from 0 to %s degrees".formatted(kind, PrintableText.number(largest)));
      }
      if (i > 0 && !(angles[i] > angles[i - 1])) {
        throw expected("a %s angle above %s".formatted(kind, PrintableText.number(angles[i - 1])));
      }
    }
    return angles;
  }

  private int count(String things) throws ModelFormatException {
    double count = next("the number of " + things);
    if (!(count >= 1) || count != Math.rint(count)) {
      throw expected("a whole number of " + things + " from 1");
    }
    scanner.require(things, MAX_ANGLES, (long) Math.min(count, Long.MAX_VALUE));
    return (int) count;
  }

  private double atLeastZero(String what) throws ModelFormatException {
    double number = next(what);
    if (!(number >= 0)) {
      throw expected(what + " of at least 0");
    }
    // 0 in place of -0.
    return number + 0.;
  }

  /** Returns the next number, on this line or a later one. */
  private double next(String what) throws ModelFormatException {
    if (!scanner.nextWordOfText()) {
      throw scanner.error("expected " + what + ", found the end of the file");
    }
    return scanner.number();
  }

  /** Returns an exception about the current word. */
  private ModelFormatException expected(String what) {
    return scanner.error("expected " + what + ", found " + PrintableText.quoted(scanner.word()));
  }

  /** Warns of numbers that are left: there may be commas in place of decimal points. */
  private void warnOfRest() {
    if (scanner.nextWordOfText() && !scanner.wordIs("\u001a")) {
      warnings.add(
          scanner.location(),
          "expected the end of the file after the last candela, found "
              + PrintableText.quoted(scanner.word()));
    }
  }

  private void warnOfFlux(double rated, double flux) {
    if (rated > 0 && flux > MAX_EFFICIENCY * rated) {
      warnings.add(
          "",
          "the lamps are rated at %s lm, but the candelas add up to %s lm"
              .formatted(
                  PrintableText.number(Math.rint(rated)), PrintableText.number(Math.rint(flux))));
    }
  }
}
