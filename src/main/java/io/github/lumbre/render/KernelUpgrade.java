package io.github.lumbre.render;

import io.github.lumbre.scene.Scene;
import java.util.concurrent.atomic.DoubleAdder;

/**
 * Changes the kernel of a scene when it pays, in a thread beside the render. Compiling the vector
 * kernel takes about two seconds of processor time, and it then saves 10&nbsp;% to 40&nbsp;% of the
 * time of a render: short renders are over sooner without.
 */
final class KernelUpgrade {
  /** With less experience, in processor seconds, the time left cannot be told: the JIT compiles. */
  private static final double LEAST_SPENT = 3;

  /** It pays from this many processor seconds on, either still to come or already spent. */
  private static final double PAYS_FROM = 8;

  /** Processor seconds of passes with plain Java, in all renders of this JVM. */
  private static final DoubleAdder SPENT = new DoubleAdder();

  private KernelUpgrade() {}

  /**
   * Takes note of a pass, and starts the change if it pays.
   *
   * @param seconds processor time of the pass
   * @param secondsLeft expected processor time of the passes to come
   */
  static void passed(Scene scene, double seconds, double secondsLeft) {
    if (!scene.mayChangeKernel()) {
      return;
    }
    SPENT.add(seconds);
    double spent = SPENT.sum();
    if (spent > LEAST_SPENT && Math.max(spent, secondsLeft) > PAYS_FROM) {
      SPENT.reset();
      Thread thread = new Thread(() -> run(scene), "lumbre-kernel");
      thread.setDaemon(true);
      thread.start();
    }
  }

  private static void run(Scene scene) {
    try {
      scene.changeKernel();
    } catch (InterruptedException | OutOfMemoryError e) {
      // The render goes on as it is.
    }
  }
}
