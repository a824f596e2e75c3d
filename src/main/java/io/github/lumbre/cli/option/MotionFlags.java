package io.github.lumbre.cli.option;

import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that blur what moves in a picture. */
@Command(optionListHeading = Headings.SEQUENCE)
public final class MotionFlags extends Flags {
  @Option(
      names = "--shutter",
      paramLabel = "FRACTION",
      description =
          "Blur what moves during this part of the time between two frames, 0 to 1, from the time"
              + " of each frame on. With --animation or --pose.")
  private Optional<Double> shutter;

  @Option(
      names = "--poses",
      paramLabel = "N",
      description =
          "Number of poses that make the blur, a power of two up to 256 (16). Each pixel gets"
              + " equally many samples of each pose.")
  private Optional<Integer> poses;

  /**
   * Checks the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is wrong
   */
  public void validate() {
    shutter.ifPresent(
        s -> require(s >= 0 && s <= 1, "--shutter: expected a fraction from 0 to 1, found " + s));
    require(
        shutter.isEmpty() || isGiven("--animation") || isGiven("--pose"),
        "--shutter: requires --animation, or --pose for a single picture");
    require(
        shutter.isEmpty() || !isGiven("--turntable"),
        "--shutter: cannot be combined with --turntable, whose model stands still");
    require(
        shutter.isEmpty() || !isGiven(FactorRange.FLAG),
        FactorRange.FLAG + ": cannot be combined with --shutter");
    require(poses.isEmpty() || shutter.isPresent(), "--poses: requires --shutter");
    SettingType<Integer> type = Setting.POSES.type();
    poses.ifPresent(
        n -> require(type.accepts(n), "--poses: expected " + type.expected() + ", found " + n));
  }

  /** Sets the time of the shutter and the poses; without a flag, those of the scene stay. */
  public void override(RenderSettings.Builder settings, FrameRate rate) {
    shutter.ifPresent(part -> settings.set(Setting.SHUTTER, part * rate.seconds() / rate.frames()));
    poses.ifPresent(count -> settings.set(Setting.POSES, count));
  }
}
