package io.github.lumbre.render;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.scene.Scene;
import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;

/**
 * Changes the kernel of a scene when it pays, in a thread beside the passes of a render. Compiling
 * the vector kernel takes about two seconds of processor time, and it then saves 10&nbsp;% to
 * 40&nbsp;% of the time of a render: short renders are faster without it.
 *
 * <p>The thread ends soon after the last pass. What it has compiled stays, and later renders start
 * it again when they have taken four times as long as it took.
 */
final class KernelUpgrade {
  /** Processor seconds before which the time left is unknown, because the JIT still compiles. */
  private static final double LEAST_SPENT = 3;

  /** The change saves time if this many processor seconds are still to come or already spent. */
  private static final double PAYS_FROM = 8;

  /**
   * For each second that a stopped change took, renders must take so many before the next one. The
   * first change begins after eight seconds and takes about two.
   */
  private static final double PRICE = 4;

  /** The processor seconds that this JVM had used before its first pass, by reading the scene. */
  private static final double READING = usedSeconds().orElse(0);

  private KernelUpgrade() {}

  /**
   * Starts the change if it pays, after a pass.
   *
   * @param seconds the time of the pass's threads, together
   * @param secondsLeft the expected time of the threads of the passes to come, together
   */
  static void passed(Scene scene, double seconds, double secondsLeft) {
    passed(scene, seconds, secondsLeft, KernelUpgrade::processorSeconds);
  }

  /**
   * Starts the change if it pays, after a pass. On a busy machine, threads wait for processors, so
   * that the processor time counts.
   *
   * @param processorSeconds the processor seconds that this JVM has used since its first pass, an
   *     upper bound of the seconds of the threads; called if the change pays without such a bound
   */
  static void passed(
      Scene scene, double seconds, double secondsLeft, DoubleSupplier processorSeconds) {
    if (!scene.mayChangeKernel()) {
      return;
    }
    double spent = CompiledKernel.spent(seconds);
    if (pays(spent, secondsLeft)) {
      double share = Math.min(1, processorSeconds.getAsDouble() / spent);
      if (!pays(share * spent, share * secondsLeft)) {
        return;
      }
      CompiledKernel.spent(-spent);
      Thread thread = new Thread(() -> run(scene), "lumbre-kernel");
      thread.setDaemon(true);
      thread.start();
    }
  }

  private static boolean pays(double spent, double left) {
    return spent > LEAST_SPENT && Math.max(spent, left) > PAYS_FROM;
  }

  /** Returns the processor time of this JVM since its first pass; infinity if it is unknown. */
  private static double processorSeconds() {
    return usedSeconds().orElse(Double.POSITIVE_INFINITY) - READING;
  }

  private static OptionalDouble usedSeconds() {
    return ProcessHandle.current().info().totalCpuDuration().stream()
        .mapToDouble(duration -> duration.toMillis() / 1000.0)
        .findFirst();
  }

  /**
   * Takes note that a change was stopped between renders. The next one begins after {@link #PRICE}
   * times as long, and not after {@link #PAYS_FROM} seconds again, so that servers that render
   * pictures with pauses between change as well.
   *
   * @param seconds the time that the change took
   */
  static void stopped(double seconds) {
    CompiledKernel.spent(PAYS_FROM - PRICE * seconds);
  }

  private static void run(Scene scene) {
    long start = System.nanoTime();
    try {
      scene.changeKernel(CompiledKernel::isRendering);
      if (scene.mayChangeKernel()) {
        stopped((System.nanoTime() - start) * 1e-9);
      }
    } catch (InterruptedException | OutOfMemoryError e) {
      // The render continues as it is.
    }
  }
}
