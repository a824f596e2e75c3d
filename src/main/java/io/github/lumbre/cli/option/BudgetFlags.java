package io.github.lumbre.cli.option;

import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.RenderSettings;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that end a render by time or noise; the first limit that is reached ends it. */
@Command(optionListHeading = Headings.STOP)
public final class BudgetFlags extends Flags {
  /** The system property that is true if the process runs one command, and nothing else. */
  public static final String OWN_PROCESS = "lumbre.process";

  @Option(
      names = "--time",
      paramLabel = "DURATION",
      description =
          "Take as many samples as fit into this time, loading and saving included (in 'view':"
              + " rendering alone), but at least 1 per pixel: 90s, 5m, 2h. Frames share the time."
              + " Without --samples, the number of samples is unlimited.")
  private Optional<Duration> time = Optional.empty();

  @Option(
      names = "--target-error",
      paramLabel = "PERCENT",
      converter = FlagConverters.OfShare.class,
      description =
          "Sample until the noise, as relative RMSE, is at most this value, such as 2%%; otherwise"
              + " exit with code 1. Frames of fewer than 64 pixels never reach a target: without"
              + " --samples and --time they end after 4096 samples per pixel.")
  private Optional<Double> targetError = Optional.empty();

  @Option(
      names = "--confidence",
      paramLabel = "PERCENT",
      converter = FlagConverters.OfShare.class,
      description = "Confidence level of the noise bound (95%%).")
  private Optional<Double> sureness = Optional.empty();

  /**
   * Checks the ranges of the values.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    sureness.ifPresent(
        c -> require(c >= .5 && c < 1, "--confidence: expected 50% to less than 100%"));
  }

  /**
   * Returns the start of this command's time: with a time limit in a process of its own, the start
   * of the JVM. To find this start takes the JVM 20 ms.
   */
  public Instant start() {
    return time.isPresent() && Boolean.getBoolean(OWN_PROCESS)
        ? Instant.ofEpochMilli(ManagementFactory.getRuntimeMXBean().getStartTime())
        : Instant.now();
  }

  /** Returns the time limit of the whole command; empty if there is none. */
  public Optional<Duration> time() {
    return time;
  }

  /**
   * Returns the share of one of the frames of this command in what is left of its time limit.
   *
   * @param start of the command
   * @param begin start of the frame
   * @param frames number of frames that are left, at least 1
   */
  public Optional<Duration> share(Instant start, Instant begin, int frames) {
    return time.map(t -> t.minus(Duration.between(start, begin)).dividedBy(frames));
  }

  /** Returns the target error; empty if there is none. */
  public OptionalDouble targetError() {
    return targetError.isPresent() ? OptionalDouble.of(targetError.get()) : OptionalDouble.empty();
  }

  /** Returns the confidence level of the noise bound. */
  public double confidence() {
    return sureness.orElse(Budget.CONFIDENCE);
  }

  /** Returns whether a time limit or a target error is given. */
  public boolean areGiven() {
    return time.isPresent() || targetError.isPresent();
  }

  /**
   * Returns the budget of a command that has already started.
   *
   * @param startup time between the start and the first line of the command
   * @param limit time limit from the start; empty if there is none
   * @param error target error if the flags set none
   * @param confidence confidence level if the flags set none
   */
  public RunBudget since(
      Instant start,
      Duration startup,
      Optional<Duration> limit,
      RenderSettings settings,
      OptionalDouble error,
      double confidence) {
    OptionalDouble target = targetError.isPresent() ? OptionalDouble.of(targetError.get()) : error;
    Budget budget = new Budget(settings.samples(), target, sureness.orElse(confidence));
    Duration spent = Duration.between(start, Instant.now());
    Optional<Duration> left =
        limit.map(t -> RunBudget.rendering(t, startup, settings).minus(spent));
    return new RunBudget(budget, Deadline.after(left));
  }
}
