package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.TimeLimit;
import io.github.lumbre.geometry.internal.HierarchyLimitException;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.io.IOException;
import java.util.concurrent.CancellationException;

/** A way to read a scene, which may take too long or too much memory. */
@FunctionalInterface
interface TimedReading<T> {
  T read() throws SceneFormatException, IOException;

  /**
   * Reads a scene within the time limit, and turns exceptions into exceptions of {@link
   * SceneParser}.
   */
  static <T> T of(Limits limits, Problems problems, TimedReading<T> reading)
      throws SceneFormatException, IOException {
    try (TimeLimit time = TimeLimit.start(limits.time())) {
      try {
        return reading.read();
      } catch (OutOfMemoryError e) {
        // What was to hold the scene is free again, and nothing else was touched.
        problems.error(Kind.LIMIT, () -> "$", "expected a scene that fits into memory");
        throw problems.exception();
      } catch (HierarchyLimitException e) {
        problems.error(Kind.LIMIT, () -> "$", e.getMessage());
        throw problems.exception();
      } catch (CancellationException e) {
        if (time.hasPassed()) {
          String limit = limits.time().toMillis() / 1e3 + " s";
          problems.error(Kind.LIMIT, () -> "$", "expected a scene that is read within " + limit);
          throw problems.exception();
        }
        throw e;
      }
    }
  }
}
