package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The header of a PLY file.
 *
 * @param comments what comments state of the content
 * @param bodyOffset of the first byte after the header
 * @param bodyLine number of the first line after the header
 */
record PlyHeader(
    Format format, List<PlyElement> elements, Comments comments, int bodyOffset, int bodyLine) {

  /**
   * What comments state: names.
   *
   * @param textures of pictures
   * @param parts of parts, which the property {@link PlyParts#PROPERTY} of faces counts from 0
   */
  record Comments(List<String> textures, List<String> parts) {
    Comments() {
      this(new ArrayList<>(), new ArrayList<>());
    }
  }

  /** The forms of numbers after the header. */
  enum Format {
    TEXT,
    LITTLE_ENDIAN,
    BIG_ENDIAN
  }

  /**
   * Returns the header of a file.
   *
   * @param warnings receives warnings about unknown lines before the first element
   */
  static PlyHeader read(byte[] file, Warnings warnings) throws ModelFormatException {
    TextScanner scanner = TextScanner.plain(file);
    if (!scanner.nextWord() || !scanner.wordIs("ply")) {
      throw scanner.error("expected \"ply\", found something else");
    }
    boolean endsInReturn = endsInReturn(file, scanner.position());
    scanner.endLine();
    Comments comments = new Comments();
    Format format = readFormat(scanner, comments);
    List<PlyElement> elements = new ArrayList<>();
    String element = "";
    int count = 0;
    List<PlyProperty> properties = new ArrayList<>();
    while (true) {
      String word = nextKeyword(scanner, comments);
      if (word.equals("property") && !element.isEmpty()) {
        properties.add(readProperty(scanner));
        scanner.require("properties", ModelLimits.MAX_PARTS, properties.size());
      } else if (word.equals("element") || word.equals("end_header")) {
        if (!element.isEmpty()) {
          elements.add(new PlyElement(element, count, List.copyOf(properties)));
          properties.clear();
        }
        if (word.equals("end_header")) {
          return atEnd(file, scanner, endsInReturn, format, elements, comments);
        }
        element = name(scanner);
        requireNew(scanner, element, elements);
        count = readCount(scanner);
      } else if (element.isEmpty() && !word.equals("property")) {
        // Blender 2.4 omitted the word "comment".
        warnings.add(scanner.location(), "ignored a line that begins with an unknown word");
      } else {
        throw scanner.error(
            "expected \"element\", \"property\" or \"end_header\", found "
                + PrintableText.quoted(word));
      }
      scanner.endLine();
    }
  }

  /** Returns whether lines end with CR alone, after which a binary body may begin with LF. */
  private static boolean endsInReturn(byte[] file, int lineEnd) {
    return lineEnd + 1 < file.length && file[lineEnd] == '\r' && file[lineEnd + 1] != '\n';
  }

  private static PlyHeader atEnd(
      byte[] file,
      TextScanner scanner,
      boolean endsInReturn,
      Format format,
      List<PlyElement> elements,
      Comments comments) {
    while (scanner.nextWord()) {
      // Nothing else belongs on this line, but binary data begins after it.
    }
    int lineEnd = scanner.position();
    scanner.endLine();
    int offset = endsInReturn ? Math.min(lineEnd + 1, file.length) : scanner.position();
    return new PlyHeader(
        format, List.copyOf(elements), comments, offset, scanner.line());
  }

  private static Format readFormat(TextScanner scanner, Comments comments)
      throws ModelFormatException {
    String word = nextKeyword(scanner, comments);
    if (!word.equals("format")) {
      throw scanner.error("expected \"format\", found " + PrintableText.quoted(word));
    }
    String name = name(scanner);
    String version = name(scanner);
    if (!version.equals("1.0")) {
      throw Kind.UNSUPPORTED.at(
          scanner.location(), "expected version 1.0, found " + PrintableText.quoted(version));
    }
    scanner.endLine();
    return switch (name) {
      case "ascii" -> Format.TEXT;
      case "binary_little_endian" -> Format.LITTLE_ENDIAN;
      case "binary_big_endian" -> Format.BIG_ENDIAN;
      default ->
          throw scanner.error(
              "expected ascii, binary_little_endian or binary_big_endian, found "
                  + PrintableText.quoted(name));
    };
  }

  /**
   * Returns the first word of the next line that is no comment.
   *
   * @param comments receives the names that comments state
   */
  private static String nextKeyword(TextScanner scanner, Comments comments)
      throws ModelFormatException {
    while (scanner.nextWordOfText()) {
      if (!scanner.wordIs("comment") && !scanner.wordIs("obj_info")) {
        return scanner.word();
      }
      String kind = scanner.nextWord() ? scanner.word() : "";
      if (kind.equalsIgnoreCase("TextureFile")) {
        addTexture(scanner, comments.textures);
      } else if (kind.equalsIgnoreCase(PlyParts.COMMENT)) {
        // An empty name counts, too: faces state the numbers of names.
        comments.parts.add(scanner.remainingWords());
        scanner.require("parts", ModelLimits.MAX_PARTS, comments.parts.size());
      }
      scanner.endLine();
    }
    throw scanner.error("expected \"end_header\", found the end of the file");
  }

  private static void addTexture(TextScanner scanner, List<String> textures)
      throws ModelFormatException {
    String name = scanner.remainingWords();
    scanner.require("textures", ModelLimits.MAX_PARTS, textures.size() + 1);
    if (!name.isEmpty()) {
      textures.add(name);
    }
  }

  private static String name(TextScanner scanner) throws ModelFormatException {
    if (!scanner.nextWord()) {
      throw scanner.error("expected a name, found the end of the line");
    }
    return scanner.word();
  }

  private static void requireNew(TextScanner scanner, String name, List<PlyElement> elements)
      throws ModelFormatException {
    scanner.require("elements", ModelLimits.MAX_PARTS, elements.size() + 1);
    if (elements.stream().anyMatch(e -> e.name().equals(name))) {
      throw scanner.error(
          "expected elements of different names, found " + PrintableText.quoted(name) + " again");
    }
  }

  private static int readCount(TextScanner scanner) throws ModelFormatException {
    if (!scanner.nextWord()) {
      throw scanner.error("expected a number of items, found the end of the line");
    }
    long count = scanner.integer(0, Long.MAX_VALUE);
    scanner.require("items", ModelLimits.MAX_COUNT, count);
    return (int) count;
  }

  private static PlyProperty readProperty(TextScanner scanner) throws ModelFormatException {
    String type = name(scanner);
    if (!type.equals("list")) {
      return new PlyProperty(name(scanner), type(scanner, type), Optional.empty());
    }
    PlyType countType = type(scanner, name(scanner));
    if (!countType.isInteger()) {
      throw scanner.error("expected an integer type for the length of a list, found a float");
    }
    PlyType itemType = type(scanner, name(scanner));
    return new PlyProperty(name(scanner), itemType, Optional.of(countType));
  }

  private static PlyType type(TextScanner scanner, String name) throws ModelFormatException {
    Optional<PlyType> type = PlyType.of(name);
    if (type.isEmpty()) {
      throw scanner.error(
          "expected a type such as float or uchar, found " + PrintableText.quoted(name));
    }
    return type.get();
  }
}
