package io.github.lumbre.model;

/** Reads the numbers of a PLY text: each item has its line. Mutable. */
final class PlyTextBody implements PlyBody {
  private final byte[] text;
  private final TextScanner scanner;
  private String element = "";

  /** Whether the scanner is at the first word of an item. */
  private boolean isAtFirstWord;

  PlyTextBody(byte[] text, PlyHeader header) {
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
        : scanner.number();
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
  public void endItem() throws ModelFormatException {
    if (scanner.nextWord()) {
      throw error("expected the end of the line, found " + PrintableText.quoted(scanner.word()));
    }
    scanner.endLine();
  }

  @Override
  public ModelFormatException error(String message) {
    return scanner.error(
        element.isEmpty()
            ? message
            : "element " + PrintableText.shortened(element) + ": " + message);
  }
}
