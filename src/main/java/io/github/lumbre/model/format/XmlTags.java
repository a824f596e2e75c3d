package io.github.lumbre.model.format;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.Arrays;

/**
 * Splits an XML text in UTF-8 into its tags. Comments and processing instructions are skipped, and
 * so are texts between tags that nobody reads; document types are refused. Mutable.
 */
final class XmlTags {
  private static final int BLOCK = 1 << 14;

  /** The first and the other bytes of what surrounds a text with brackets. */
  private static final String SECTION = "CDATA[";

  private final XmlSource in;
  private final byte[] block = new byte[BLOCK];
  private int at;
  private int end;
  private int line = 1;
  private int tagLine = 1;
  private final XmlTag tag = new XmlTag();

  /** Whether the bracket before the next tag has been read. */
  private boolean isAtTag;

  /** Whether the next bytes are a text within a CDATA section. */
  private boolean isInSection;

  private byte[] text = new byte[64];
  private int textSize;

  XmlTags(XmlSource in) {
    this.in = in;
  }

  /** Moves behind the next tag; returns false at the end of the file. */
  boolean next() throws ModelFormatException {
    while (isAtTag || isInSection || skipTo('<')) {
      tagLine = line;
      if (isInSection) {
        skipBehind("]]>");
        isInSection = false;
      } else if (isAtTag || !skipMarkup()) {
        isAtTag = false;
        readTag();
        return true;
      }
    }
    return false;
  }

  /**
   * Moves behind what is no tag, behind a bracket; returns false at a tag. A CDATA section begins
   * then.
   */
  private boolean skipMarkup() throws ModelFormatException {
    int first = peek();
    if (first == '?') {
      skipBehind("?>");
    } else if (first == '!') {
      nextByte();
      int kind = nextByte();
      if (kind == '-') {
        skipBehind("-->");
      } else if (kind == '[') {
        isInSection = true;
      } else {
        throw error("expected XML without a document type, found \"<!\"");
      }
    } else {
      return false;
    }
    return true;
  }

  /**
   * Moves to the next word before the next tag; returns false if there is none. Comments end words.
   */
  boolean nextWord() throws ModelFormatException {
    textSize = 0;
    while (!isAtTag && (at < end || peek() >= 0)) {
      byte c = block[at];
      if (isBracket(c)) {
        if (textSize > 0) {
          return true;
        }
        skipBracket();
        continue;
      }
      at++;
      if (XmlTag.isSpace(c)) {
        line += c == '\n' ? 1 : 0;
        if (textSize > 0) {
          return true;
        }
      } else {
        addText(c);
      }
    }
    return textSize > 0;
  }

  /** Returns the text before the next tag. */
  String text() throws ModelFormatException {
    textSize = 0;
    while (!isAtTag && (at < end || peek() >= 0)) {
      byte c = block[at];
      if (isBracket(c)) {
        skipBracket();
      } else {
        at++;
        line += c == '\n' ? 1 : 0;
        addText(c);
      }
    }
    return XmlTag.decoded(text, 0, textSize);
  }

  private boolean isBracket(byte c) {
    return c == (isInSection ? ']' : '<');
  }

  /** Moves behind a bracket of a text: at a tag, behind a comment, or into or out of a section. */
  private void skipBracket() throws ModelFormatException {
    nextByte();
    if (!isInSection) {
      isAtTag = !skipMarkup();
      for (int i = 0; isInSection && i < SECTION.length() && peek() == SECTION.charAt(i); i++) {
        nextByte();
      }
    } else {
      endSection();
    }
  }

  /** Moves behind square brackets within a section, and out of it if they are its end. */
  private void endSection() throws ModelFormatException {
    int brackets = 1;
    while (peek() == ']') {
      nextByte();
      brackets++;
    }
    isInSection = brackets < 2 || peek() != '>';
    if (!isInSection) {
      nextByte();
      brackets -= 2;
    }
    for (int i = 0; i < brackets; i++) {
      addText((byte) ']');
    }
  }

  private void addText(byte c) throws ModelFormatException {
    if (textSize == text.length) {
      if (textSize == XmlTag.MAX_BYTES) {
        throw Kind.TOO_LARGE.at(
            location(line), "expected a text of at most " + XmlTag.MAX_BYTES + " bytes");
      }
      text = Arrays.copyOf(text, 2 * textSize);
    }
    text[textSize++] = c;
  }

  /** Returns the bytes of the current word, with others behind it. */
  byte[] word() {
    return text;
  }

  /** Returns the number of bytes of the current word. */
  int wordSize() {
    return textSize;
  }

  private void readTag() throws ModelFormatException {
    int quote = 0;
    tag.clear();
    for (int c = nextByte(); quote != 0 || c != '>'; c = nextByte()) {
      if (c < 0) {
        throw error("expected the end of a tag, found the end of the file");
      }
      if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = 0;
      }
      tag.add(c, in.part(), tagLine);
    }
  }

  /** Returns the current tag, always the same object. */
  XmlTag tag() {
    return tag;
  }

  /** Returns the name of the part that is read, for messages. */
  String part() {
    return in.part();
  }

  /** Returns the number of the line in which the current tag begins, from 1. */
  int line() {
    return tagLine;
  }

  /** Returns the place of the current tag, for messages. */
  String location() {
    return location(tagLine);
  }

  /** Returns the place of the current word, for messages. */
  String wordLocation() {
    return location(line);
  }

  private String location(int number) {
    return (in.part().isEmpty() ? "line " : in.part() + " line ") + number;
  }

  /** Returns an exception that names the place of the current tag. */
  ModelFormatException error(String message) {
    return Kind.MALFORMED.at(location(), message);
  }

  /** Skips to the byte behind the next one of a value; returns false at the end. */
  private boolean skipTo(int wanted) throws ModelFormatException {
    int c = nextByte();
    while (c >= 0 && c != wanted) {
      c = nextByte();
    }
    return c >= 0;
  }

  private void skipBehind(String mark) throws ModelFormatException {
    long last = 0;
    long wanted = 0;
    long mask = 0;
    for (int i = 0; i < mark.length(); i++) {
      wanted = wanted << 8 | mark.charAt(i);
      mask = mask << 8 | 0xff;
    }
    while (last != wanted) {
      int c = nextByte();
      if (c < 0) {
        throw error("expected \"" + mark + "\", found the end of the file");
      }
      last = (last << 8 | c) & mask;
    }
  }

  private int peek() throws ModelFormatException {
    if (at == end) {
      at = 0;
      end = in.read(block, 0);
    }
    return at == end ? -1 : block[at] & 0xff;
  }

  /** Returns the next byte; -1 at the end. */
  private int nextByte() throws ModelFormatException {
    int c = peek();
    at += c < 0 ? 0 : 1;
    line += c == '\n' ? 1 : 0;
    return c;
  }
}
