package io.github.lumbre.spark;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.scene.RenderSettings;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;

/**
 * What executors have and need, estimated before work starts.
 *
 * @param master the cluster's URL
 * @param cores cores of one executor
 * @param heapBytes maximum heap of one executor
 * @param neededBytes estimate of the heap that an executor needs
 * @param hasVectors whether executors may use the vector kernel
 */
record ExecutorPlan(
    String master, int cores, long heapBytes, long neededBytes, boolean hasVectors) {
  private static final String VECTOR_MODULE = "jdk.incubator.vector";

  /** Heap that Spark reserves for itself (Spark 4.2, "Memory Management Overview"). */
  private static final long SPARK_BYTES = 300L << 20;

  /** Pixels of the largest unit's film and its copies. */
  private static final long UNIT_PIXELS = 3L * Units.LARGEST * Units.LARGEST;

  /**
   * Returns the plan of a scene that has just been read.
   *
   * @param layers what the films record besides the picture
   * @param fileBytes size of the scene's files, which executors receive
   */
  static ExecutorPlan of(
      JavaSparkContext spark, RenderSettings settings, FilmLayers layers, long fileBytes) {
    SparkConf conf = spark.getConf();
    long unitBytes = UNIT_PIXELS * (Film.MAX_PIXEL_BYTES + layers.bytesPerPixel());
    MemoryEstimate driver = MemoryEstimate.measured(settings, layers);
    if (spark.isLocal()) {
      int cores = spark.defaultParallelism();
      long needed = driver.neededBytes() + 2 * fileBytes + cores * unitBytes;
      boolean hasVectors = Kernel.vectorObstacle().isEmpty();
      return new ExecutorPlan(spark.master(), cores, driver.maxHeapBytes(), needed, hasVectors);
    }
    int cores = conf.getInt("spark.executor.cores", 1);
    long needed = SPARK_BYTES + driver.sceneBytes() + 2 * fileBytes + cores * unitBytes;
    long heap = conf.getSizeAsBytes("spark.executor.memory", "1g");
    String options = conf.get("spark.executor.extraJavaOptions", "");
    return new ExecutorPlan(spark.master(), cores, heap, needed, options.contains(VECTOR_MODULE));
  }

  /** Returns a line for the user. */
  String line() {
    return "Spark on %s: an executor has %d cores and %s, and needs about %s; vector kernel %s"
        .formatted(
            master,
            cores,
            MemoryEstimate.mebibytes(heapBytes),
            MemoryEstimate.mebibytes(neededBytes),
            hasVectors
                ? "on"
                : "off (spark.executor.extraJavaOptions=--add-modules=" + VECTOR_MODULE + ")");
  }

  /**
   * Requires that the heap of executors is large enough.
   *
   * @throws TaskException that states the needed and the available memory, if it is not
   */
  void require() throws TaskException {
    if (neededBytes > heapBytes) {
      throw new TaskException(
          ExitCode.LIMIT,
          "an executor with %d cores needs about %s of memory, but has %s; raise it with %s"
              .formatted(
                  cores,
                  MemoryEstimate.mebibytes(neededBytes),
                  MemoryEstimate.mebibytes(heapBytes),
                  master.startsWith("local[")
                      ? "LUMBRE_JAVA_OPTS=-Xmx8g"
                      : "--conf spark.executor.memory=8g"));
    }
  }
}
