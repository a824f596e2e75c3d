package io.github.lumbre.model.format;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;

/**
 * Splits an XML text in UTF-8 into its tags. Texts between them, comments and processing
 * instructions are skipped; document types are refused. Mutable.
 */
final class XmlTags {
  private static final int BLOCK = 1 << 14;

  private final ZipInput in;
  private final byte[] block = new byte[BLOCK];
  private int at;
  private int end;
  private int line = 1;
  private int tagLine = 1;
  private final XmlTag tag = new XmlTag();

  XmlTags(ZipInput in) {
    this.in = in;
  }

  /** Moves behind the next tag; returns false at the end of the file. */
  boolean next() throws ModelFormatException {
    while (skipTo('<')) {
      tagLine = line;
      int first = peek();
      if (first == '?') {
        skipBehind("?>");
      } else if (first == '!') {
        skipMarkup();
      } else {
        readTag();
        return true;
      }
    }
    return false;
  }

  private void skipMarkup() throws ModelFormatException {
    nextByte();
    int kind = nextByte();
    if (kind == '-') {
      skipBehind("-->");
    } else if (kind == '[') {
      skipBehind("]]>");
    } else {
      throw error("expected XML without a document type, found \"<!\"");
    }
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
    return in.part() + " line " + tagLine;
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
