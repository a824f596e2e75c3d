package io.github.lumbre.mutants;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A change of one place in a source file.
 *
 * @param file below the root package's folder, such as {@code material/Lambertian.java}
 * @param before whole lines, which must stand there exactly once
 * @param after what takes their place
 */
record Edit(String file, List<String> before, List<String> after) {
  Edit {
    before = List.copyOf(before);
    after = List.copyOf(after);
  }

  /**
   * Returns the changed source.
   *
   * @throws MutantException if the lines do not stand there, or more than once
   */
  List<String> applyTo(List<String> source) throws MutantException {
    int at = Collections.indexOfSubList(source, before);
    if (at < 0) {
      throw new MutantException(file + " has no lines\n" + String.join("\n", before));
    }
    if (at != Collections.lastIndexOfSubList(source, before)) {
      throw new MutantException(file + " has more than once\n" + String.join("\n", before));
    }
    List<String> changed = new ArrayList<>(source.subList(0, at));
    changed.addAll(after);
    changed.addAll(source.subList(at + before.size(), source.size()));
    return changed;
  }
}
