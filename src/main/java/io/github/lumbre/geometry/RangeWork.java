package io.github.lumbre.geometry;

import java.util.concurrent.RecursiveAction;

/**
 * Work on the numbers of a range, which is independent of that on other ranges.
 *
 * <p>Implementations are classes where each process needs them: Java links a lambda when it is
 * first met, which takes as long as a thousand triangles.
 */
interface RangeWork {
  /** Works on the numbers in [first, end). */
  void run(int first, int end);

  /**
   * Works on [0, count) in parts of at most the given size, which the fork-join pool of the caller
   * shares; on a smaller range directly, without a pool.
   */
  default void runAll(int count, int grain) {
    if (count <= grain) {
      run(0, count);
    } else {
      new Part(this, 0, count, grain).invoke();
    }
  }

  /** The work on a part of the range. */
  final class Part extends RecursiveAction {
    private static final long serialVersionUID = 1;

    private final transient RangeWork work;
    private final int first;
    private final int end;
    private final int grain;

    private Part(RangeWork work, int first, int end, int grain) {
      this.work = work;
      this.first = first;
      this.end = end;
      this.grain = grain;
    }

    @Override
    protected void compute() {
      if (end - first <= grain) {
        work.run(first, end);
        return;
      }
      int middle = (first + end) >>> 1;
      invokeAll(new Part(work, first, middle, grain), new Part(work, middle, end, grain));
    }
  }
}
