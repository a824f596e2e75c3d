package io.github.lumbre.model.program;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;

/**
 * A call of a program: its path, and words that are its arguments as they stand, without a shell.
 * Immutable.
 *
 * @param arguments with {@link #IN} and {@link #OUT} in the places of the two files
 */
record Template(Path program, List<String> arguments) {
  static final String IN = "{in}";
  static final String OUT = "{out}";

  /** Stands for the script of a known program. */
  static final String SCRIPT = "{script}";

  private static final String FORM =
      "expected '/path/program {in} {out}', with the absolute path of a program";

  /**
   * Returns the template in a text, whose words are separated by spaces.
   *
   * @throws IllegalArgumentException if it is none; the message states what was found
   */
  static Template of(String text) {
    List<String> words = List.of(text.strip().split("\\s+"));
    List<String> arguments = words.subList(1, words.size());
    Path program = path(words.get(0));
    if (text.contains("'") || text.contains("\"")) {
      throw wrong("a quote, which has no meaning without a shell", text);
    }
    for (String word : List.of(IN, OUT)) {
      if (Collections.frequency(arguments, word) != 1) {
        throw wrong(word + " not once as a word of its own", text);
      }
    }
    if (!program.isAbsolute()) {
      throw wrong("a program without an absolute path", text);
    }
    if (!Files.isRegularFile(program) || !Files.isExecutable(program)) {
      throw wrong("no program at this path", text);
    }
    return new Template(program, arguments);
  }

  private static Path path(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new IllegalArgumentException(FORM + ", found no path: " + text, e);
    }
  }

  private static IllegalArgumentException wrong(String found, String text) {
    return new IllegalArgumentException(FORM + ", found " + found + ": " + text);
  }
}
