package io.github.lumbre.stage.thumbnail;

import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;

/** A picture to be rendered, with the time at which the work on it begins. Thread-safe. */
final class Request extends FutureTask<byte[]> {
  private volatile boolean begun;
  private volatile long begin;

  Request(Callable<byte[]> work) {
    super(work);
  }

  @Override
  public void run() {
    begin = System.nanoTime();
    begun = true;
    super.run();
  }

  /** Returns the seconds since the work began; 0 if it has not. */
  double seconds() {
    return begun ? (System.nanoTime() - begin) * 1e-9 : 0;
  }
}
