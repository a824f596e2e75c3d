package io.github.lumbre.scenefile;

import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.function.Supplier;

/**
 * A place in a scene at which problems are reported.
 *
 * @param path as in {@link Problem#path}
 */
record ProblemPlace(Problems problems, Supplier<String> path) {
  void error(Kind kind, String message) {
    problems.error(kind, path, message);
  }

  void warn(String message) {
    problems.warn(path, () -> message);
  }
}
