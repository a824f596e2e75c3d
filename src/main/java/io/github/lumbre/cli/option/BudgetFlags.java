package io.github.lumbre.cli.option;

import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stopping.Budget;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flags that end a render otherwise than by a number of samples; what comes first ends it. */
public final class BudgetFlags {
  /** The property that tells when the program was started, in milliseconds since 1970. */
  public static final String START = "lumbre.start";

  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--time",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      description =
          "Take as many samples as fit into such a time, reading and writing "
              + "included: 90s, 5m, 2h, but at least one for each pixel. "
              + "Without --samples there is no other limit.")
  private Optional<Duration> time = Optional.empty();

  @Option(
      names = "--target-error",
      paramLabel = "P",
      converter = FlagConverters.OfShare.class,
      description =
          "Take samples until the noise is at most so much, as relative root "
              + "mean squared error: 2%%. If something else ends the render before, "
              + "the exit code is 1. Frames of fewer than 64 pixels never reach it: without "
              + "--samples and --time they end after 4096 samples per pixel.")
  private Optional<Double> targetError = Optional.empty();

  @Option(
      names = "--confidence",
      paramLabel = "P",
      converter = FlagConverters.OfShare.class,
      description = "How sure the bound of the noise is to be (95%%).")
  private Optional<Double> sureness = Optional.empty();

  /**
   * Complains about values out of range.
   *
   * @throws ParameterException naming the flag
   */
  public void validate() {
    sureness.ifPresent(
        c -> {
          if (c < .5 || c >= 1) {
            throw new ParameterException(
                spec.commandLine(), "--confidence: expected 50% to less than 100%");
          }
        });
  }

  /** Returns when the time of this command began: when the program did, if it runs this alone. */
  public static Instant start() {
    Long millis = Long.getLong(START);
    return millis == null ? Instant.now() : Instant.ofEpochMilli(millis);
  }

  /** Returns the time that the whole command is to take; empty if none limits it. */
  public Optional<Duration> time() {
    return time;
  }

  /** Tells whether a time or an error is to end the render. */
  public boolean areGiven() {
    return time.isPresent() || targetError.isPresent();
  }

  /**
   * Returns the budget of a command that began some time ago.
   *
   * @param startup that passed before it could do anything
   * @param error to be reached if these flags name none
   * @param confidence if these flags name none
   */
  public RunBudget since(
      Instant start,
      Duration startup,
      RenderSettings settings,
      OptionalDouble error,
      double confidence) {
    OptionalDouble target = targetError.isPresent() ? OptionalDouble.of(targetError.get()) : error;
    Budget budget = new Budget(settings.samples(), target, sureness.orElse(confidence));
    Duration spent = Duration.between(start, Instant.now());
    Optional<Duration> left = time.map(t -> RunBudget.rendering(t, startup, settings).minus(spent));
    return new RunBudget(budget, Deadline.after(left));
  }
}
