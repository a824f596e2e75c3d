package io.github.lumbre.cli.option;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The flags that set quality presets and adaptive sampling. */
@Command(optionListHeading = Headings.STOP)
public final class QualityFlags {
  @Option(
      names = "--quality",
      paramLabel = "NAME",
      description =
          "Set --target-error and --depth together: draft (20%%, 3), preview (10%%, 5), final (3%%,"
              + " 16), reference (1%%, 1000). These flags override the preset.")
  private Optional<Quality> quality = Optional.empty();

  @Option(
      names = "--adaptive",
      description =
          "Give more samples to pixels where they reduce the noise most, after the first 32 of"
              + " every pixel. --samples is then the mean; up to 32, the flag has no effect. Not"
              + " with --checkpoint.")
  private boolean adaptive;

  /** Returns whether noisy pixels get more samples. */
  public boolean isAdaptive() {
    return adaptive;
  }

  /** Returns the path depth of the given preset; empty if none is given. */
  public OptionalInt depth() {
    return quality.map(q -> OptionalInt.of(q.depth())).orElseGet(OptionalInt::empty);
  }

  /** Returns the target error of the given preset; empty if none is given. */
  public OptionalDouble targetError() {
    return quality.map(q -> OptionalDouble.of(q.targetError())).orElseGet(OptionalDouble::empty);
  }
}
