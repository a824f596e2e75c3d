package io.github.lumbre.render;

import java.util.List;

/** The threads that run the workers of a pass. */
interface Crew {
  /**
   * Runs workers until the queue is exhausted or stopped. No worker runs any more when it returns
   * or throws.
   *
   * @throws InterruptedException if the calling thread is interrupted
   * @throws RenderException if a worker failed
   */
  void run(List<BucketWorker> workers, RenderQueue queue, Progress progress)
      throws InterruptedException;

  /**
   * Returns the number of own threads that may render the pilot; 0 for the calling thread alone.
   *
   * @param wanted threads of a pass
   */
  default int pilotThreads(int wanted) {
    return wanted;
  }

  /** Returns the exception for the failure of a worker. */
  static RenderException failure(Throwable cause) {
    return new RenderException("rendering failed: " + cause, cause);
  }
}
