package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * Splits the text of a model file into lines and words. Lines end with LF, CR LF or CR. A UTF-8
 * byte order mark is skipped. In OBJ, MTL and OFF texts, comments begin with #, and a backslash at
 * the end of a line joins it with the next. Mutable.
 */
public final class TextScanner {
  /** Lines between two checks for an interrupt; a power of two. */
  private static final int LINES_PER_CHECK = 1 << 14;

  /** The largest absolute value: products of two numbers must not overflow. */
  private static final double MAX_NUMBER = 1e150;

  /** Words for NaN and infinities, such as nan, -inf, nan(ind) and 1.#QNAN. */
  private static final Pattern NOT_FINITE =
      Pattern.compile("[-+]?(nan(\\(\\w*\\))?|inf(inity)?|1\\.#\\w+)", Pattern.CASE_INSENSITIVE);

  private final byte[] text;
  private final String file;

  /** Whether the text has comments and joined lines. */
  private final boolean isObj;

  private int at;
  private int line;
  private int start;
  private int end;

  /** Scans an OBJ or OFF text. */
  public TextScanner(byte[] text) {
    this(text, "");
  }

  /**
   * Scans an OBJ or MTL text.
   *
   * @param file name of the file for messages; empty for the model file itself
   */
  public TextScanner(byte[] text, String file) {
    this(text, file, true, beginsWithMark(text) ? 3 : 0, 1);
  }

  private TextScanner(byte[] text, String file, boolean isObj, int at, int line) {
    this.text = text;
    this.file = file;
    this.isObj = isObj;
    this.at = at;
    this.line = line;
  }

  /** Returns a scanner of a text without comments and joined lines. */
  public static TextScanner plain(byte[] text) {
    return plain(text, beginsWithMark(text) ? 3 : 0, 1);
  }

  /**
   * Returns a scanner of a text within a line of another one.
   *
   * @param file name of the file for messages
   * @param line number of the line in the file
   */
  public static TextScanner within(byte[] text, String file, int line) {
    return new TextScanner(text, file, false, 0, line);
  }

  /**
   * Returns a scanner of the end of a text without comments and joined lines.
   *
   * @param from offset of the first byte
   * @param line number of the first line
   */
  public static TextScanner plain(byte[] text, int from, int line) {
    return new TextScanner(text, "", false, from, line);
  }

  private static boolean beginsWithMark(byte[] text) {
    return text.length >= 3
        && text[0] == (byte) 0xef
        && text[1] == (byte) 0xbb
        && text[2] == (byte) 0xbf;
  }

  /** Returns whether any text is left. */
  public boolean hasMore() {
    return at < text.length;
  }

  /** Returns the offset of the next byte. */
  public int position() {
    return at;
  }

  /** Returns the number of the current line, from 1. */
  public int line() {
    return line;
  }

  /** Moves to the next word of this line; returns false if there is none. */
  public boolean nextWord() {
    skipBlanks();
    start = at;
    while (at < text.length && !isSpace(text[at]) && !isJoint()) {
      at++;
    }
    end = at;
    return end > start;
  }

  /** Returns whether another word follows on this line. */
  public boolean hasMoreWords() {
    int savedAt = at;
    int savedLine = line;
    int savedStart = start;
    int savedEnd = end;
    boolean found = nextWord();
    at = savedAt;
    line = savedLine;
    start = savedStart;
    end = savedEnd;
    return found;
  }

  /** Skips the rest of this line and moves to the beginning of the next one. */
  public void endLine() {
    while (at < text.length && !isLineEnd(text[at])) {
      if (isJoint()) {
        skipJoint();
      } else {
        at++;
      }
    }
    if (at < text.length) {
      skipLineEnd();
    }
    if ((line & LINES_PER_CHECK - 1) == 0) {
      Interrupts.check();
    }
  }

  private void skipBlanks() {
    while (at < text.length) {
      if (isJoint()) {
        skipJoint();
      } else if (isObj && text[at] == '#') {
        skipComment();
      } else if (!isLineEnd(text[at]) && isSpace(text[at])) {
        at++;
      } else {
        return;
      }
    }
  }

  private void skipComment() {
    while (at < text.length && !isLineEnd(text[at])) {
      at++;
    }
  }

  private boolean isJoint() {
    return isObj && text[at] == '\\' && at + 1 < text.length && isLineEnd(text[at + 1]);
  }

  private void skipJoint() {
    at++;
    skipLineEnd();
  }

  private static boolean isLineEnd(byte c) {
    return c == '\n' || c == '\r';
  }

  private void skipLineEnd() {
    boolean isPair = text[at] == '\r' && at + 1 < text.length && text[at + 1] == '\n';
    at += isPair ? 2 : 1;
    line++;
  }

  private static boolean isSpace(byte c) {
    return c == ' ' || c >= '\t' && c <= '\r';
  }

  /** Moves to the next word of this line or a later one; returns false if there is none. */
  public boolean nextWordOfText() {
    while (!nextWord()) {
      if (!hasMore()) {
        return false;
      }
      endLine();
    }
    return true;
  }

  /** Returns whether the current word is the expected one. */
  public boolean wordIs(String expected) {
    if (end - start != expected.length()) {
      return false;
    }
    for (int i = 0; i < expected.length(); i++) {
      if (text[start + i] != expected.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the current word, byte by byte. */
  public String word() {
    return new String(text, start, end - start, StandardCharsets.ISO_8859_1);
  }

  /** Returns the remaining words of this line, joined by single spaces; empty if there are none. */
  public String remainingWords() {
    StringBuilder words = new StringBuilder();
    while (nextWord()) {
      words.append(words.length() == 0 ? "" : " ").append(name());
    }
    return words.toString();
  }

  /** Returns the current word as UTF-8. */
  public String name() {
    return new String(text, start, end - start, StandardCharsets.UTF_8);
  }

  /** Returns the next word of the line as a finite number; the decimal separator is a point. */
  public double nextNumber() throws ModelFormatException {
    if (!nextWord()) {
      throw error("expected a number, found the end of the line");
    }
    return number();
  }

  /** Returns the current word as a finite number. */
  public double number() throws ModelFormatException {
    double simple = Decimals.exact(text, start, end);
    if (!Double.isNaN(simple)) {
      return simple;
    }
    for (int i = start; i < end; i++) {
      // Double.parseDouble alone would accept "NaN", "1f" and "0x1p3".
      byte c = text[i];
      if (!isDigit(c) && c != '.' && c != '-' && c != '+' && c != 'e' && c != 'E') {
        throw notANumber();
      }
    }
    double number;
    try {
      number = Double.parseDouble(word());
    } catch (NumberFormatException e) {
      throw notANumber();
    }
    if (Double.isInfinite(number)) {
      throw notANumber();
    }
    if (Math.abs(number) > MAX_NUMBER) {
      throw error("expected a number of at most 1e150, found " + PrintableText.quoted(word()));
    }
    return number;
  }

  /** Returns the current word as a number, or NaN if it is a word for NaN or infinity. */
  public double numberOrNan() throws ModelFormatException {
    double simple = Decimals.exact(text, start, end);
    if (!Double.isNaN(simple)) {
      return simple;
    }
    return NOT_FINITE.matcher(word()).matches() ? Double.NaN : number();
  }

  /**
   * Returns the current word as an integer.
   *
   * @throws ModelFormatException if it is none, or lies outside the range
   */
  public long integer(long min, long max) throws ModelFormatException {
    int i = text[start] == '-' || text[start] == '+' ? start + 1 : start;
    long value = 0;
    boolean sound = i < end && end - i <= 18;
    for (; sound && i < end; i++) {
      sound = isDigit(text[i]);
      value = 10 * value + text[i] - '0';
    }
    value = text[start] == '-' ? -value : value;
    if (!sound || value < min || value > max) {
      throw error(
          "expected an integer from %s to %s, found %s"
              .formatted(min, max, PrintableText.quoted(word())));
    }
    return value;
  }

  private ModelFormatException notANumber() {
    return error("expected a finite number, found " + PrintableText.quoted(word()));
  }

  /**
   * Reads the current word as indices separated by slashes: {@code 5}, {@code 5/6}, {@code 5//7} or
   * {@code 5/6/7}.
   *
   * @param indices receives three numbers as written in the file; 0 for a missing one
   */
  public void readIndices(int[] indices) throws ModelFormatException {
    int i = start;
    for (int k = 0; k < 3; k++) {
      int from = i;
      while (i < end && text[i] != '/') {
        i++;
      }
      indices[k] = i > from ? index(from, i) : 0;
      if (i < end && k < 2) {
        i++;
      }
    }
    if (i < end || indices[0] == 0) {
      throw notIndices();
    }
  }

  private int index(int from, int to) throws ModelFormatException {
    boolean negative = text[from] == '-';
    int first = negative || text[from] == '+' ? from + 1 : from;
    long value = 0;
    for (int i = first; i < to; i++) {
      if (!isDigit(text[i]) || value > Integer.MAX_VALUE) {
        throw notIndices();
      }
      value = 10 * value + text[i] - '0';
    }
    if (first == to || value > Integer.MAX_VALUE) {
      throw notIndices();
    }
    if (value == 0) {
      throw error("expected indices that start at 1, found 0 in " + PrintableText.quoted(word()));
    }
    return (int) (negative ? -value : value);
  }

  private ModelFormatException notIndices() {
    return error("expected indices such as 1/2/3, found " + PrintableText.quoted(word()));
  }

  private static boolean isDigit(byte c) {
    return c >= '0' && c <= '9';
  }

  /** Checks a number of things as {@link ModelLimits#require} does; the error names the line. */
  public void require(String things, long max, long found) throws ModelFormatException {
    ModelLimits.require(location(), things, max, found);
  }

  /** Returns an exception that names the line. */
  public ModelFormatException error(String message) {
    return Kind.MALFORMED.at(location(), message);
  }

  /** Returns the current place, for messages. */
  public String location() {
    return file.isEmpty() ? "line " + line : file + " line " + line;
  }
}
