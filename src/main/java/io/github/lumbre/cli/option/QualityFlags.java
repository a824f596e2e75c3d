package io.github.lumbre.cli.option;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import picocli.CommandLine.Option;

/** The flags that say how good a picture is to be by other flags, and which pixels need most. */
public final class QualityFlags {
  @Option(
      names = "--quality",
      paramLabel = "NAME",
      converter = FlagConverters.OfQuality.class,
      description =
          "draft: --target-error 20%% --depth 3; preview: 10%%, 5; final: 3%%, 16; "
              + "reference: 1%%, 1000. Flags of those names win.")
  private Optional<Quality> quality = Optional.empty();

  @Option(
      names = "--adaptive",
      description =
          "Give more of the samples to pixels where they take off more noise; "
              + "--samples is the mean then, and must exceed 32, the samples that all pixels "
              + "get first. Not with --checkpoint.")
  private boolean adaptive;

  /** Tells whether noisy pixels are to get more samples. */
  public boolean isAdaptive() {
    return adaptive;
  }

  /** Returns the depth of paths that goes with the quality asked for; empty if none was. */
  public OptionalInt depth() {
    return quality.map(q -> OptionalInt.of(q.depth())).orElseGet(OptionalInt::empty);
  }

  /** Returns the error that goes with the quality asked for; empty if none was. */
  public OptionalDouble targetError() {
    return quality.map(q -> OptionalDouble.of(q.targetError())).orElseGet(OptionalDouble::empty);
  }
}
