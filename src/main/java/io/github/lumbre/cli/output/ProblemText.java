package io.github.lumbre.cli.output;

import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFormatException;
import java.util.List;
import java.util.Set;

/** Writes the problems of a scene, with flags where the library names Java arguments. Stateless. */
public final class ProblemText {
  /** The arguments that {@link Problem#path} names. */
  private static final Set<String> ARGUMENTS =
      Set.of("sky", "size", "hide", "highlight", "section");

  private ProblemText() {}

  /** Returns one line. */
  public static String of(Problem problem) {
    return new Problem(problem.file(), place(problem.path()), problem.message()).toString();
  }

  /** Returns one line for each problem. */
  public static List<String> of(SceneFormatException e) {
    return e.problems().stream().map(ProblemText::of).toList();
  }

  /** Returns the place of a problem: a flag, or the path in the file. */
  public static String place(String path) {
    return ARGUMENTS.contains(path) ? "--" + path : path;
  }
}
