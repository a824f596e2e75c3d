package io.github.lumbre.geometry;

import java.util.concurrent.RecursiveAction;

/** Work on the parts of a range of numbers, which the fork-join pool of the caller shares. */
final class ParallelRange extends RecursiveAction {
  private static final long serialVersionUID = 1;

  private final int first;
  private final int end;
  private final int grain;
  private final transient Body body;

  /** The work on numbers in [first, end), independent of that on others. */
  interface Body {
    void run(int first, int end);
  }

  private ParallelRange(int first, int end, int grain, Body body) {
    this.first = first;
    this.end = end;
    this.grain = grain;
    this.body = body;
  }

  /**
   * Works on [0, count) in parts of at most the given size; on a smaller range directly, without a
   * pool.
   */
  static void run(int count, int grain, Body body) {
    new ParallelRange(0, count, grain, body).start();
  }

  private void start() {
    if (end - first <= grain) {
      body.run(first, end);
    } else {
      invoke();
    }
  }

  @Override
  protected void compute() {
    if (end - first <= grain) {
      body.run(first, end);
      return;
    }
    int middle = (first + end) >>> 1;
    invokeAll(
        new ParallelRange(first, middle, grain, body), new ParallelRange(middle, end, grain, body));
  }
}
