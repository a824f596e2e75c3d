package io.github.lumbre.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.TinyScene;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the time limit of a render with a simulated clock that samples advance, so no test depends
 * on the machine.
 */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RunBudgetTest {
  private static final int PIXELS = 64 * 48;

  /** More samples per pixel than any of these time limits allows. */
  private static final int MANY = 1000;

  @TempDir private Path directory;

  private final StringWriter told = new StringWriter();

  /** Advances a clock by the cost of samples. */
  private record SampleClock(AtomicLong nanos, AtomicLong samples, LongUnaryOperator cost)
      implements ProgressDisplay {
    SampleClock(LongUnaryOperator cost) {
      this(new AtomicLong(), new AtomicLong(), cost);
    }

    @Override
    public void started(long totalSamples) {}

    @Override
    public void expected(long furtherSamples) {}

    @Override
    public void advanced(long count) {
      for (long i = 0; i < count; i++) {
        nanos.addAndGet(cost.applyAsLong(samples.getAndIncrement()));
      }
    }

    @Override
    public void close() {}
  }

  /** Returns the samples per pixel of a render with a time limit. */
  private double samples(Duration time, LongUnaryOperator cost)
      throws Exception {
    return samples(time, Optional.empty(), cost);
  }

  /**
   * Returns the samples per pixel of a render with a time limit.
   *
   * @param timeout stops the render as Ctrl-C does; empty for none
   */
  private double samples(Duration time, Optional<Duration> timeout, LongUnaryOperator cost)
      throws Exception {
    SceneFile file =
        new SceneParser()
            .overriding(
                settings -> settings.toBuilder().samples(MANY).size(64, 48).threads(1).build())
            .parse(TinyScene.write(directory, TinyScene.JSON));
    SampleClock clock = new SampleClock(cost);
    Messages messages = new Messages(new PrintWriter(told, true));
    Path target = directory.resolve("a.png");
    Files.deleteIfExists(target);
    try (PictureOutput picture = PictureOutput.reserve(target, Fallback.TEMPORARY);
        FilmKeeper keeper = FilmKeeper.none(messages);
        Interruption interruption = Interruption.listen();
        RenderMonitor monitor =
            new RenderMonitor(
                interruption, clock, Deadline.after(timeout, clock.nanos()::get), messages)) {
      RunBudget budget =
          new RunBudget(
              new Budget(MANY, OptionalDouble.empty(), .95),
              Deadline.after(Optional.of(time), clock.nanos()::get));
      RenderJob.Options options =
          new RenderJob.Options(
              8,
              90,
              false,
              false,
              false,
              Optional.empty(),
              Set.of(),
              PictureExposure.ofEach(),
              drawn -> {},
              hint -> {},
              true,
              Optional.empty());
      JsonSummary report = new JsonSummary("render", target);
      ExitCode code =
          new RenderJob(
                  target,
                  file,
                  picture,
                  keeper,
                  monitor,
                  messages,
                  report,
                  budget,
                  options,
                  Engine.LOCAL)
              .run(0);
      assertThat(code).isEqualTo(ExitCode.OK);
    }
    return clock.samples().get() / (double) PIXELS;
  }

  /**
   * The first 1000 samples, while the JIT compiles, cost 1 ms each and take 1 s; all others cost 20
   * µs. A report of up to 1024 samples may come after the time limit.
   */
  @Test
  void samplesGrowInProportionToTheTimeAfterWarmUp() throws Exception {
    for (int seconds : new int[] {2, 3, 5, 10}) {
      double expected = (1000 + (seconds - 1) / 20e-6) / PIXELS;
      double found = samples(Duration.ofSeconds(seconds), i -> i < 1000 ? 1_000_000 : 20_000);
      assertThat(found).as("in " + seconds + " s").isCloseTo(expected, within(1100.0 / PIXELS));
    }
    assertThat(told.toString()).doesNotContain("warning");
  }

  /**
   * Warm-up takes 3 s, more than the limit of 2 s: only the first pass is completed, with a
   * warning.
   */
  @Test
  void warmUpLongerThanTheTimeLeavesOneSampleAndAWarning() throws Exception {
    assertThat(samples(Duration.ofSeconds(2), i -> i < 3000 ? 1_000_000 : 20_000)).isEqualTo(1);
    assertThat(told.toString()).contains("warning: --time was too short: only the first pass");
  }

  @Test
  void stoppedFirstPassesTellTheShareOfPixelsWithoutASample() throws Exception {
    Duration time = Duration.ofMinutes(1);
    double share = samples(time, Optional.of(Duration.ofSeconds(1)), i -> 1_000_000);
    assertThat(share).isBetween(1000.0 / PIXELS, 2100.0 / PIXELS);
    assertThat(told.toString())
        .contains("warning: %.0f %% of the pixels have no sample".formatted(100 - 100 * share));
  }

  /** Of each additional second of --time, rendering gets all but 1/50. */
  @Test
  void whatIsKeptForTheEndIsNearlyConstant() {
    RenderSettings settings = new RenderSettings.Builder().size(512, 512).build();
    Duration startup = Duration.ofMillis(300);
    Duration before = RunBudget.rendering(Duration.ofSeconds(2), startup, settings);
    assertThat(before).isBetween(Duration.ofMillis(1250), Duration.ofMillis(1950));
    for (int seconds = 3; seconds <= 20; seconds++) {
      Duration after = RunBudget.rendering(Duration.ofSeconds(seconds), startup, settings);
      assertThat(after.minus(before)).isBetween(Duration.ofMillis(980), Duration.ofSeconds(1));
      before = after;
    }
  }

  /** The JIT compiles the vector kernel for seconds; meanwhile, the scalar kernel renders. */
  @Test
  void shortTimesAreNotSpentOnCompilingTheVectorKernel() {
    Optional<Duration> shortTime = Optional.of(Duration.ofSeconds(5));
    assertThat(KernelFlag.within(shortTime, Kernel.AUTO)).isEqualTo(Kernel.SCALAR);
    assertThat(KernelFlag.within(Optional.of(Duration.ofMinutes(1)), Kernel.AUTO))
        .isEqualTo(Kernel.AUTO);
    assertThat(KernelFlag.within(Optional.empty(), Kernel.AUTO)).isEqualTo(Kernel.AUTO);
    assertThat(KernelFlag.within(shortTime, Kernel.VECTOR)).isEqualTo(Kernel.VECTOR);
  }
}
