package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scenefile.internal.Origin;
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
  private final Optional<String> aroundModel;
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
    this(file, isModel ? Optional.of("") : Optional.empty());
  }

  /**
   * @param file name of the scene file for messages
   * @param aroundModel instead of paths in the scene around a model, which no file contains; empty
   *     for other scenes
   */
  Problems(String file, Optional<String> aroundModel) {
    this.file = PrintableText.escaped(file);
    this.aroundModel = aroundModel;
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

  /**
   * Adds a warning that is not the same as the last one; beyond {@link #MAX_WARNINGS}, only counts
   * it and computes no text.
   */
  void warn(Supplier<String> path, Supplier<String> message) {
    if (warnings.size() < MAX_WARNINGS) {
      Problem found = new Problem(file, place(path.get()), message.get());
      if (warnings.isEmpty() || !found.equals(warnings.get(warnings.size() - 1))) {
        warnings.add(found);
      }
    } else {
      unsaidWarnings++;
    }
  }

  private String place(String path) {
    return PrintableText.path(path.startsWith("$") ? aroundModel.orElse(path) : path);
  }

  /** Returns the place of an object or asset; around a model, its name is its place. */
  Origin origin(String path, String name) {
    boolean isNamed = aroundModel.filter(place -> !place.isEmpty()).isPresent();
    return new Origin(isNamed ? name : PrintableText.path(path), name);
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
