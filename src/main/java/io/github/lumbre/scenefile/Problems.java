package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.internal.ModelReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** Collects the errors and warnings of a scene, up to a limit each. Mutable. */
final class Problems {
  static final int MAX_ERRORS = 20;
  static final int MAX_WARNINGS = 1000;

  private final String file;
  private final boolean isModel;
  private final List<Problem> errors = new ArrayList<>();
  private final List<Problem> warnings = new ArrayList<>();
  private Optional<SceneFormatException.Kind> kind = Optional.empty();
  private int unsaidWarnings;

  /**
   * @param file name of the scene file for messages, or of a model that is rendered by itself
   */
  Problems(String file) {
    this(file, ModelReader.isModelName(file));
  }

  /**
   * @param file name of the scene file for messages
   * @param isModel whether the file is a model that is rendered by itself: no problem then has a
   *     path in the scene around it, which no file contains
   */
  Problems(String file, boolean isModel) {
    this.file = PrintableText.escaped(file);
    this.isModel = isModel;
  }

  /** Adds an error; beyond {@link #MAX_ERRORS}, errors are dropped. */
  void error(SceneFormatException.Kind kindOfError, Supplier<String> path, String message) {
    if (kind.isEmpty()) {
      kind = Optional.of(kindOfError);
    }
    if (errors.size() < MAX_ERRORS) {
      errors.add(new Problem(file, place(path.get()), message));
    }
  }

  /** Adds a warning; beyond {@link #MAX_WARNINGS}, only counts it and computes no text. */
  void warn(Supplier<String> path, Supplier<String> message) {
    if (warnings.size() < MAX_WARNINGS) {
      warnings.add(new Problem(file, place(path.get()), message.get()));
    } else {
      unsaidWarnings++;
    }
  }

  private String place(String path) {
    return PrintableText.path(isModel && path.startsWith("$") ? "" : path);
  }

  boolean hasErrors() {
    return !errors.isEmpty();
  }

  /** Returns the warnings; beyond the limit, the last one states how many are missing. */
  List<Problem> warnings() {
    List<Problem> all = new ArrayList<>(warnings);
    if (unsaidWarnings > 0) {
      all.add(new Problem(file, "", "and " + unsaidWarnings + " more warnings"));
    }
    return all;
  }

  /** Returns the errors as an exception; there must be at least one. */
  SceneFormatException exception() {
    return new SceneFormatException(kind.orElseThrow(), errors);
  }

  /**
   * Throws the collected errors.
   *
   * @throws SceneFormatException if there is any error
   */
  void throwIfAny() throws SceneFormatException {
    if (hasErrors()) {
      throw exception();
    }
  }

  /** Returns where a file was sought, if its path says more than its name. */
  static String at(Path file) {
    return file.getNameCount() == 1 && !file.isAbsolute()
        ? ""
        : " at " + PrintableText.quoted(file.toString());
  }
}
