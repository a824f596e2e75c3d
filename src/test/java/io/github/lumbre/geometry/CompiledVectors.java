package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.CompiledKernel;

/** What this JVM knows about the vector kernel, for tests of other packages. */
public final class CompiledVectors {
  private CompiledVectors() {}

  /**
   * Awaits the changes of kernels that renders have started, and forgets that the vector kernel is
   * compiled, so that new scenes start with plain Java.
   */
  public static void forget() throws InterruptedException {
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().equals("lumbre-kernel")) {
        thread.join();
      }
    }
    CompiledKernel.setCompiled(false);
  }
}
