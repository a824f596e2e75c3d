package io.github.lumbre.cli.option;

import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that select the samples of each pixel. Mutable: picocli stores the values here. */
@Command(optionListHeading = Headings.SAMPLES)
public final class SampleFlags extends Flags {
  @Mixin private final SamplesFlag samples = new SamplesFlag();

  @Option(
      names = "--samples-from",
      paramLabel = "N",
      description =
          "Index of each pixel's first sample (0). 'lumbre merge' joins checkpoint files with"
              + " consecutive samples.")
  private Optional<Integer> samplesFrom;

  @Option(
      names = "--samples-to",
      paramLabel = "M",
      description = "End index of each pixel's samples, exclusive; instead of --samples.")
  private Optional<Integer> samplesTo;

  @Option(
      names = "--share",
      paramLabel = "I/N",
      description =
          "Render share I (from 0) of N of the samples, for 'lumbre merge'; auto: the share of this"
              + " process in a job array. Needs --checkpoint.")
  private Optional<String> share;

  /** The index of the first sample of the share, once the scene's number of samples is known. */
  private int firstOfShare;

  /**
   * Checks the ranges of the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    samples.validate();
    samplesFrom.ifPresent(
        n -> checks().requireIn("--samples-from", 0, RenderSettings.MAX_SAMPLES - 1, n));
    samplesTo.ifPresent(
        n -> checks().requireIn("--samples-to", first() + 1, RenderSettings.MAX_SAMPLES, n));
    require(
        !samples.isGiven() || samplesTo.isEmpty(),
        "--samples and --samples-to: expected only one of them");
    require(
        part().isEmpty() || samplesFrom.isEmpty() && samplesTo.isEmpty(),
        "--share: cannot be combined with --samples-from or --samples-to, which select samples"
            + " too");
  }

  /** Returns whether the flags select a range of sample indices. */
  public boolean haveRange() {
    return samplesFrom.isPresent() || samplesTo.isPresent() || share.isPresent();
  }

  /** Returns whether the flags select a share of the samples. */
  public boolean haveShare() {
    return share.isPresent();
  }

  /** Returns the index of each pixel's first sample; of a share, once the scene is read. */
  public int first() {
    return share.isPresent() ? firstOfShare : samplesFrom.orElse(0);
  }

  void override(RenderSettings.Builder builder) {
    samples.override(builder);
    samplesTo.ifPresent(n -> builder.samples(n - first()));
    part().ifPresent(part -> select(part, builder));
    int poses = builder.build().poses();
    samplesFrom.ifPresent(n -> requireWhole("--samples-from", n, poses));
    samplesTo.ifPresent(n -> requireWhole("--samples-to", n, poses));
  }

  private Optional<Share> part() {
    try {
      return share.map(text -> Share.parse(text, System.getenv()));
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--share: " + e.getMessage(), e);
    }
  }

  private void requireWhole(String flag, int samples, int poses) {
    require(
        samples % poses == 0,
        flag + ": expected a multiple of the number of poses, " + poses + ", found " + samples);
  }

  /** Limits the samples to the share, which has equally many of each pose. */
  private void select(Share part, RenderSettings.Builder builder) {
    RenderSettings whole = builder.build().withWholePoses();
    int poses = whole.poses();
    int all = whole.samples() / poses;
    try {
      firstOfShare = poses * part.first(all, poses == 1 ? "sample" : "pose set");
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--share: " + e.getMessage(), e);
    }
    builder.samples(poses * part.end(all) - firstOfShare);
  }
}
