package io.github.lumbre.model.format;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Decimals;
import io.github.lumbre.model.internal.TextScanner;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads the elements of an XML text in UTF-8, their attributes and their texts, tag by tag.
 * Comments and processing instructions are skipped. There are no document types, so that there are
 * no entities but the five of XML 1.0 and those by number. Mutable.
 *
 * <p>{@link #nextWithin} moves to the children of an element; the methods that return attributes
 * are about the element to which it moved last. Before it moves on, the text of that element can be
 * read once, up to its first child: whole, or word by word, in any length.
 */
public final class XmlReader {
  /** The most elements within each other, unless a format needs more. */
  private static final int MAX_DEPTH = 100;

  private static final int MAX_ATTRIBUTES = 100;

  /** The largest absolute value of a number: products of two must not overflow. */
  private static final double MAX_NUMBER = 1e150;

  private static final int LONGEST_NUMBER = 400;

  private final XmlTags tags;
  private final int maxDepth;

  private final XmlTag tag;
  private int nameStart;
  private int nameEnd;

  /** Begin and end of name and value of each attribute. */
  private final int[] ranges = new int[4 * MAX_ATTRIBUTES];

  private int attributes;

  /** The names of the open elements, from the root on, without an empty one. */
  private final List<String> open = new ArrayList<>();

  private final XmlNamespaces namespaces = new XmlNamespaces();

  private String firstComma = "";

  /** Whether the current element is an empty one, such as {@code <a/>}. */
  private boolean isClosed;

  public XmlReader(XmlSource in) {
    this(in, MAX_DEPTH);
  }

  /**
   * @param maxDepth the most elements within each other
   */
  public XmlReader(XmlSource in, int maxDepth) {
    tags = new XmlTags(in);
    tag = tags.tag();
    this.maxDepth = maxDepth;
  }

  /** Returns the depth of the current element: 1 for the root. */
  public int depth() {
    return open.size() + (isClosed ? 1 : 0);
  }

  /**
   * Moves to the next child of an element; skips what is within the children before it.
   *
   * @param depth of the element; 0 for the document
   * @return false at the end of the element
   */
  public boolean nextWithin(int depth) throws ModelFormatException {
    while (true) {
      if (isClosed) {
        isClosed = false;
        namespaces.leave(open.size());
      }
      if (open.size() < depth || !nextTag()) {
        return false;
      }
      if (depth() == depth + 1 && !tag.isEnd()) {
        return true;
      }
    }
  }

  /** Moves behind the next tag; returns false at the end of the document. */
  private boolean nextTag() throws ModelFormatException {
    if (!tags.next()) {
      if (!open.isEmpty()) {
        throw error(
            "expected </" + PrintableText.shortened(last()) + ">, found the end of the file");
      }
      return false;
    }
    if (tag.isEnd()) {
      endElement();
    } else {
      startElement();
    }
    return true;
  }

  private void endElement() throws ModelFormatException {
    String name = tag.string(1, tag.wordEnd(1));
    if (open.isEmpty() || !last().equals(name)) {
      throw error(
          open.isEmpty()
              ? "expected an element, found its end"
              : "expected </%s>, found </%s>"
                  .formatted(PrintableText.shortened(last()), PrintableText.shortened(name)));
    }
    open.remove(open.size() - 1);
    namespaces.leave(open.size());
  }

  private void startElement() throws ModelFormatException {
    isClosed = tag.dropSlash();
    nameStart = 0;
    nameEnd = tag.wordEnd(0);
    attributes = 0;
    if (nameEnd == 0) {
      throw error("expected the name of an element, found none");
    }
    if (open.size() == maxDepth) {
      throw Kind.TOO_LARGE.at(
          location(), "expected at most " + maxDepth + " elements within each other, found more");
    }
    if (!isClosed) {
      open.add(tag.string(0, nameEnd));
    }
    int from = tag.skipSpace(nameEnd);
    while (from < tag.size()) {
      from = tag.skipSpace(readAttribute(from));
    }
    int colon = tag.indexOf(':', 0, nameEnd);
    nameStart = colon < 0 ? 0 : colon + 1;
  }

  private int readAttribute(int from) throws ModelFormatException {
    int to = tag.indexOf('=', from, tag.size());
    int quoteAt = tag.skipSpace(to + 1);
    if (to < 0 || quoteAt >= tag.size() || tag.at(quoteAt) != '"' && tag.at(quoteAt) != '\'') {
      throw error("expected an attribute with a value in quotes, found something else");
    }
    int valueEnd = tag.indexOf(tag.at(quoteAt), quoteAt + 1, tag.size());
    if (valueEnd < 0) {
      throw error("expected a value in quotes, found no second quote");
    }
    if (attributes == MAX_ATTRIBUTES) {
      throw Kind.TOO_LARGE.at(location(), "expected at most " + MAX_ATTRIBUTES + " attributes");
    }
    int nameTo = Math.min(tag.wordEnd(from), to);
    int[] range = {from, nameTo, quoteAt + 1, valueEnd};
    System.arraycopy(range, 0, ranges, 4 * attributes, 4);
    attributes++;
    if (tag.startsWith(from, "xmlns") && (nameTo == from + 5 || tag.at(from + 5) == ':')) {
      String prefix = tag.string(Math.min(from + 6, nameTo), nameTo);
      namespaces.declare(prefix, tag.decoded(quoteAt + 1, valueEnd), depth(), location());
    }
    return valueEnd + 1;
  }

  /** Returns the namespace of a prefix; empty if it has none. */
  public String namespace(String prefix) {
    return namespaces.of(prefix);
  }

  public String namespace() {
    return namespace(nameStart == 0 ? "" : tag.string(0, nameStart - 1));
  }

  /** Returns the name of the element without its prefix. */
  public String name() {
    return tag.string(nameStart, nameEnd);
  }

  public boolean is(String namespace, String name) {
    return nameEnd - nameStart == name.length()
        && tag.startsWith(nameStart, name)
        && namespace().equals(namespace);
  }

  /** Returns the index of an attribute without a prefix; -1 if there is none. */
  private int find(String name) {
    for (int i = 0; i < 4 * attributes; i += 4) {
      if (ranges[i + 1] - ranges[i] == name.length() && tag.startsWith(ranges[i], name)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns whether the element has an attribute without a prefix. */
  public boolean has(String name) {
    return find(name) >= 0;
  }

  /** Returns whether the element has an attribute that is not empty, with any prefix or none. */
  public boolean hasLocal(String name) {
    for (int i = 0; i < 4 * attributes; i += 4) {
      int start = ranges[i + 1] - name.length();
      boolean isWhole = start == ranges[i] || start > ranges[i] && tag.at(start - 1) == ':';
      if (isWhole && tag.startsWith(start, name) && ranges[i + 3] > ranges[i + 2]) {
        return true;
      }
    }
    return false;
  }

  /** Returns the value of an attribute without a prefix. */
  public Optional<String> text(String name) {
    int i = find(name);
    return i < 0 ? Optional.empty() : Optional.of(tag.decoded(ranges[i + 2], ranges[i + 3]));
  }

  /** Returns the value of an attribute in a namespace, which has a prefix. */
  public Optional<String> text(String namespace, String name) {
    for (int i = 0; i < 4 * attributes; i += 4) {
      int colon = tag.indexOf(':', ranges[i], ranges[i + 1]);
      if (colon >= 0
          && tag.string(colon + 1, ranges[i + 1]).equals(name)
          && namespace(tag.string(ranges[i], colon)).equals(namespace)) {
        return Optional.of(tag.decoded(ranges[i + 2], ranges[i + 3]));
      }
    }
    return Optional.empty();
  }

  private int require(String name) throws ModelFormatException {
    int i = find(name);
    if (i < 0) {
      throw error("expected the attribute " + name + " of <" + name() + ">, found none");
    }
    return i;
  }

  /** Returns a number, or NaN for a word that means NaN or infinity. */
  public double number(String name) throws ModelFormatException {
    int i = require(name);
    double simple = tag.simpleNumber(ranges[i + 2], ranges[i + 3]);
    if (!Double.isNaN(simple)) {
      return simple;
    }
    TextScanner words = words(name);
    if (!words.nextWord()) {
      throw error("expected a number in " + name + ", found none");
    }
    return words.numberOrNan();
  }

  /** Returns a scanner of the words of an attribute, whose line ends count as spaces. */
  public TextScanner words(String name) throws ModelFormatException {
    int i = require(name);
    byte[] value = new byte[ranges[i + 3] - ranges[i + 2]];
    for (int k = 0; k < value.length; k++) {
      byte c = tag.at(ranges[i + 2] + k);
      value[k] = XmlTag.isSpace(c) ? (byte) ' ' : c;
    }
    return TextScanner.within(value, tags.part(), tags.line());
  }

  /**
   * Returns an integer.
   *
   * @param max the largest allowed value
   */
  public int integer(String name, long max) throws ModelFormatException {
    int i = require(name);
    long value = ranges[i + 2] == ranges[i + 3] ? Long.MAX_VALUE : 0;
    for (int k = ranges[i + 2]; k < ranges[i + 3] && value <= max; k++) {
      boolean isDigit = tag.at(k) >= '0' && tag.at(k) <= '9';
      value = isDigit ? 10 * value + tag.at(k) - '0' : Long.MAX_VALUE;
    }
    if (value > max) {
      throw error(
          "expected an integer from 0 to %d in %s, found %s"
              .formatted(
                  max, name, PrintableText.quoted(tag.decoded(ranges[i + 2], ranges[i + 3]))));
    }
    return (int) value;
  }

  /** Returns the text of the element before its first child. */
  public String text() throws ModelFormatException {
    return isClosed ? "" : tags.text();
  }

  /** Moves to the next word of the element's text; returns false if there is none. */
  public boolean nextWord() throws ModelFormatException {
    return !isClosed && tags.nextWord();
  }

  /** Returns where the first comma is that was taken for a decimal point; empty if none was. */
  public String firstComma() {
    return firstComma;
  }

  /**
   * Returns the current word as a number; NaN if it is none, is not finite or is beyond 1e150. A
   * comma is taken for the decimal point.
   */
  public double wordNumber() {
    double simple = Decimals.exact(tags.word(), 0, tags.wordSize());
    return Double.isNaN(simple) ? otherNumber() : simple;
  }

  private double otherNumber() {
    if (tags.wordSize() > LONGEST_NUMBER) {
      return Double.NaN;
    }
    String word = new String(tags.word(), 0, tags.wordSize(), StandardCharsets.ISO_8859_1);
    double number = parsed(word);
    if (firstComma.isEmpty() && word.indexOf(',') >= 0 && !Double.isNaN(number)) {
      firstComma = wordLocation();
    }
    return number;
  }

  /** Returns a word as a number, as {@link #wordNumber} does. */
  public static double parsed(String word) {
    for (int i = 0; i < word.length(); i++) {
      // Double.parseDouble alone would accept "NaN", "1f" and "0x1p3".
      if (i == LONGEST_NUMBER || "0123456789.,-+eE".indexOf(word.charAt(i)) < 0) {
        return Double.NaN;
      }
    }
    try {
      double number = Double.parseDouble(word.replace(',', '.'));
      return Math.abs(number) <= MAX_NUMBER ? number : Double.NaN;
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Returns the current word as an integer from 0 to 2^31 - 1; -1 if it is none. */
  public int wordIndex() {
    byte[] word = tags.word();
    long value = 0;
    for (int i = 0; i < tags.wordSize(); i++) {
      value = 10 * value + word[i] - '0';
      if (word[i] < '0' || word[i] > '9' || value > Integer.MAX_VALUE) {
        return -1;
      }
    }
    return (int) value;
  }

  /** Returns the place of the current word, for messages. */
  public String wordLocation() {
    return tags.wordLocation();
  }

  /** Returns the name of the part that is read, for messages. */
  public String part() {
    return tags.part();
  }

  /** Returns the place of the element, for messages. */
  public String location() {
    return tags.location();
  }

  /** Returns an exception that names the place of the element. */
  public ModelFormatException error(String message) {
    return tags.error(message);
  }

  private String last() {
    return open.get(open.size() - 1);
  }
}
