package io.github.lumbre.spark;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.render.stopping.BudgetWatch;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.apache.spark.SimpleFutureAction;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.rdd.RDD;
import scala.collection.immutable.Seq;
import scala.jdk.javaapi.CollectionConverters;
import scala.runtime.AbstractFunction0;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/**
 * Renders passes on Spark. Each call renders one job: a part of the pass small enough for Spark's
 * limit of a job's results, and for a checkpoint between jobs. Mutable, for one render.
 */
final class SparkPasses implements PassRenderer {
  /** Units of a job for each core, at most. */
  private static final int UNITS_PER_CORE = 24;

  /** Units of a pass for each core, at least: the last ones leave cores idle. */
  private static final int LEAST_PER_CORE = 12;

  /** Results of a job, uncompressed: half of Spark's default limit. */
  private static final long JOB_BYTES = 1L << 29;

  /** Samples per second and core, before any is measured. */
  private static final double FIRST_RATE = 100_000;

  private static final long POLL_MILLIS = 100;

  /** The time after which missing executors are reported; Spark itself keeps trying. */
  private static final double PATIENCE_SECONDS = 30;

  private final JavaSparkContext spark;
  private final Broadcast<SceneBundle> bundle;
  private final FilmRenderer local;
  private final int goal;
  private final double unitSeconds;
  private final boolean isTimed;
  private final Consumer<String> messages;
  private final long start = System.nanoTime();
  private boolean isMissingTold;
  private double measuredSamples;
  private double measuredSeconds;

  /**
   * @param goal samples per pixel at the end
   * @param unitSeconds time that a unit should take
   * @param isTimed whether a time ends the render, so that passes should be short
   * @param messages receives lines for the user
   */
  SparkPasses(
      JavaSparkContext spark,
      Broadcast<SceneBundle> bundle,
      FilmRenderer local,
      int goal,
      double unitSeconds,
      boolean isTimed,
      Consumer<String> messages) {
    this.spark = spark;
    this.bundle = bundle;
    this.local = local;
    this.goal = goal;
    this.unitSeconds = unitSeconds;
    this.isTimed = isTimed;
    this.messages = messages;
  }

  /** Returns passes that end where a render on one machine checks its error. */
  @Override
  public Schedule schedule() {
    return isTimed ? local.schedule() : Schedule.even(goal, BudgetWatch::nextCheck);
  }

  @Override
  public OptionalDouble seconds(Film film, SampleTarget target) {
    double missing = 0;
    for (WorkUnit unit : units(film, target)) {
      missing += unit.samples();
    }
    return OptionalDouble.of(missing / (rate() * cores()));
  }

  /** Returns samples per second and core. */
  private double rate() {
    return measuredSeconds == 0 ? FIRST_RATE : measuredSamples / measuredSeconds;
  }

  private int cores() {
    return Math.max(1, SparkFailures.explained(spark, spark::defaultParallelism));
  }

  private List<WorkUnit> units(Film film, SampleTarget target) {
    long missing = 0;
    for (WorkUnit unit : Units.of(film, target, Long.MAX_VALUE)) {
      missing += unit.samples();
    }
    long most = Math.min((long) (rate() * unitSeconds), missing / (LEAST_PER_CORE * cores()));
    return Units.of(film, target, Math.max(1, most));
  }

  @Override
  public PassResult addSamples(Film film, SampleTarget target, Progress progress)
      throws InterruptedException {
    List<WorkUnit> all = units(film, target);
    if (all.isEmpty()) {
      return new PassResult(true, RenderStatistics.ZERO);
    }
    List<WorkUnit> now = firstJob(all, Film.MAX_PIXEL_BYTES + film.layers().bytesPerPixel());
    int end = now.stream().mapToInt(unit -> unit.first() + unit.count()).max().getAsInt();
    spark
        .sc()
        .setJobDescription(
            "%s: samples %d to %d per pixel, %d units"
                .formatted(bundle.value().name(), film.fewestSamples(), end - 1, now.size()));
    Job job = new Job(film, progress);
    boolean isComplete = SparkFailures.explained(spark, () -> job.run(now));
    return new PassResult(isComplete && now.size() == all.size(), job.statistics);
  }

  private List<WorkUnit> firstJob(List<WorkUnit> all, int pixelBytes) {
    long bytes = 0;
    int count = 0;
    while (count < all.size() && count < UNITS_PER_CORE * cores()) {
      WorkUnit unit = all.get(count);
      bytes += (long) unit.width() * unit.height() * pixelBytes;
      if (count > 0 && bytes > JOB_BYTES) {
        break;
      }
      count++;
    }
    return all.subList(0, count);
  }

  /** The units of one Spark job, whose films are added as they arrive. */
  private final class Job {
    private final Film film;
    private final Progress progress;
    private final BlockingQueue<UnitResult> arrived = new LinkedBlockingQueue<>();

    /** Films that wait for earlier samples of their tile, by tile and first sample. */
    private final Map<Long, TreeMap<Integer, UnitResult>> early = new HashMap<>();

    private RenderStatistics statistics = RenderStatistics.ZERO;

    Job(Film film, Progress progress) {
      this.film = film;
      this.progress = progress;
    }

    /** Renders units and returns whether all are complete. */
    boolean run(List<WorkUnit> units) throws InterruptedException {
      RDD<WorkUnit> rdd = spark.parallelize(units, units.size()).rdd();
      SimpleFutureAction<Object> action =
          spark
              .sc()
              .submitJob(
                  rdd,
                  new UnitRenderer(bundle),
                  partitions(units),
                  new Arrival(arrived),
                  new End());
      boolean isCancelled = false;
      try {
        while (!action.isCompleted() || !arrived.isEmpty()) {
          UnitResult result = arrived.poll(POLL_MILLIS, TimeUnit.MILLISECONDS);
          if (result != null) {
            accept(result);
          } else {
            tellMissingExecutors();
          }
          if (!isCancelled && progress.isCancelled()) {
            isCancelled = true;
            action.cancel();
          }
        }
      } catch (InterruptedException e) {
        action.cancel();
        throw e;
      }
      if (isCancelled) {
        return false;
      }
      scala.util.Try<Object> outcome = action.value().get();
      if (outcome.isFailure()) {
        throw SparkFailures.failure(spark, outcome.failed().get());
      }
      return true;
    }

    private static Seq<Object> partitions(List<WorkUnit> units) {
      List<Object> numbers = new java.util.ArrayList<>();
      for (int i = 0; i < units.size(); i++) {
        numbers.add(i);
      }
      return CollectionConverters.asScala(numbers).toSeq();
    }

    private void accept(UnitResult result) {
      WorkUnit unit = result.unit();
      long tile = (long) unit.y() << 32 | unit.x();
      TreeMap<Integer, UnitResult> waiting = early.computeIfAbsent(tile, t -> new TreeMap<>());
      waiting.put(unit.first(), result);
      while (!waiting.isEmpty()
          && waiting.firstKey() == film.firstSample() + film.samples(unit.x(), unit.y())) {
        add(waiting.pollFirstEntry().getValue());
      }
      if (waiting.isEmpty()) {
        early.remove(tile);
      }
      measuredSamples += unit.samples();
      measuredSeconds += result.seconds();
    }

    private void add(UnitResult result) {
      film.addAll(result.decoded(film.layers()));
      statistics = statistics.plus(result.statistics());
      progress.advanced(result.unit().samples());
    }
  }

  /** Tells once that no executor has started. */
  private void tellMissingExecutors() {
    // The driver counts as an executor, and in local mode it is the only one.
    if (!isMissingTold
        && (System.nanoTime() - start) * 1e-9 > PATIENCE_SECONDS
        && !spark.isLocal()
        && spark.sc().getExecutorMemoryStatus().size() < 2) {
      isMissingTold = true;
      messages.accept(
          "warning: no executor has started for %.0f s; %s"
              .formatted(PATIENCE_SECONDS, SparkFailures.logs(spark)));
    }
  }

  /** Receives the result of each partition once, in Spark's own thread. */
  private static final class Arrival extends AbstractFunction2<Object, UnitResult, BoxedUnit> {
    private final BlockingQueue<UnitResult> arrived;

    Arrival(BlockingQueue<UnitResult> arrived) {
      this.arrived = arrived;
    }

    @Override
    public BoxedUnit apply(Object partition, UnitResult result) {
      arrived.add(result);
      return BoxedUnit.UNIT;
    }
  }

  /** The value of a finished job. */
  private static final class End extends AbstractFunction0<Object> {
    @Override
    public Object apply() {
      return BoxedUnit.UNIT;
    }
  }
}
