package io.github.lumbre.spark;

import io.github.lumbre.render.RenderException;
import org.apache.spark.api.java.JavaSparkContext;

/** States the cause of failures that Spark reports in its own terms. */
final class SparkFailures {
  /** What precedes the message of an executor's failure. */
  private static final String EXECUTOR_FAILURE = IllegalStateException.class.getName() + ": ";

  /** What Spark says when the executors of an application end again and again. */
  private static final String REMOVED = "removed our application";

  private SparkFailures() {}

  /**
   * Work that calls Spark.
   *
   * @param <X> what it may throw
   */
  @FunctionalInterface
  interface Work<T, X extends Exception> {
    T done() throws X;
  }

  /**
   * Returns the result of work.
   *
   * @throws RenderException that names the cause, if Spark has stopped
   */
  static <T, X extends Exception> T explained(JavaSparkContext spark, Work<T, X> work) throws X {
    try {
      return work.done();
    } catch (IllegalStateException e) {
      throw spark.sc().isStopped() ? failure(spark, e) : e;
    }
  }

  /** Returns the exception that names the cause of a failure. */
  static RenderException failure(JavaSparkContext spark, Throwable cause) {
    return new RenderException("rendering on Spark failed: " + reason(spark, cause), cause);
  }

  /** Returns the message of an executor's failure, without Spark's stack traces. */
  private static String reason(JavaSparkContext spark, Throwable failure) {
    String message = String.valueOf(failure.getMessage());
    String first = message.lines().findFirst().orElse(failure.toString());
    // Spark passes on an executor's exception as text only.
    int own = first.indexOf(EXECUTOR_FAILURE);
    if (own >= 0) {
      return first.substring(own + EXECUTOR_FAILURE.length());
    }
    return spark.sc().isStopped() || first.contains(REMOVED)
        ? "the executors could not start, or all have ended; " + logs(spark)
        : first;
  }

  /** Returns where the cause of executors that do not start is found. */
  static String logs(JavaSparkContext spark) {
    return "the logs of the workers and work/%s/*/stderr there name the cause"
        .formatted(spark.sc().applicationId());
  }
}
