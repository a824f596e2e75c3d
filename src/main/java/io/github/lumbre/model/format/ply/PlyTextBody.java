package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;

/** Reads the numbers of a PLY text: each item has its line. Mutable. */
final class PlyTextBody implements PlyBody {
  private final byte[] text;
  private final TextScanner scanner;
  private String element = "";

  /** Whether the scanner is at the first word of an item. */
  private boolean isAtFirstWord;

  private final Tally tally;

  /**
   * @param tally receives the items whose line has more words than numbers
   */
  PlyTextBody(byte[] text, PlyHeader header, Tally tally) {
    this.tally = tally;
    this.text = text;
    scanner = TextScanner.plain(text, header.bodyOffset(), header.bodyLine());
  }

  @Override
  public long remainingBytes() {
    // The last separator may be missing.
    return text.length - scanner.position() + 1L;
  }

  @Override
  public long minBytes(PlyElement item) {
    return item.minTextBytes();
  }

  @Override
  public void beginItem(PlyElement item, int number) throws ModelFormatException {
    element = item.name();
    if (!scanner.nextWordOfText()) {
      throw error("expected " + item.count() + " items, found " + number);
    }
    isAtFirstWord = true;
  }

  private void nextWord(PlyProperty property) throws ModelFormatException {
    if (!isAtFirstWord && !scanner.nextWord()) {
      throw error(
          "expected a number for "
              + PrintableText.shortened(property.name())
              + ", found the end of the line");
    }
    isAtFirstWord = false;
  }

  @Override
  public double number(PlyProperty property) throws ModelFormatException {
    nextWord(property);
    return property.type().isInteger()
        ? scanner.integer(property.type().min(), property.type().max())
        : scanner.numberOrNan();
  }

  @Override
  public long integer(PlyProperty property) throws ModelFormatException {
    nextWord(property);
    return scanner.integer(property.type().min(), property.type().max());
  }

  @Override
  public int listLength(PlyProperty property) throws ModelFormatException {
    nextWord(property);
    long max =
        Math.max(0, Math.min(remainingBytes() / 2, property.countType().orElseThrow().max()));
    return (int) scanner.integer(0, max);
  }

  @Override
  public void endItem() {
    if (scanner.nextWord()) {
      tally.add("ignored words at the end of a line", location());
    }
    scanner.endLine();
  }

  @Override
  public String location() {
    return scanner.location() + ": element " + PrintableText.shortened(element);
  }

  @Override
  public ModelFormatException error(String message) {
    return scanner.error(
        element.isEmpty()
            ? message
            : "element " + PrintableText.shortened(element) + ": " + message);
  }
}
