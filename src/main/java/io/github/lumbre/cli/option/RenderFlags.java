package io.github.lumbre.cli.option;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.Setting.Group;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneParser;
import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that override a scene's render settings. */
@Command(optionListHeading = Headings.TRANSPORT)
public final class RenderFlags extends Flags {
  @Option(
      names = "--mode",
      paramLabel = "MODE",
      description = "Render mode: ray (Whitted) or path (path tracing). Default: scene or path.")
  private Optional<Mode> mode;

  @Option(
      names = "--depth",
      paramLabel = "N",
      description = {
        "Path mode: maximum number of scattering vertices of a path (scene or 5; models: 12).",
        "Ray mode: maximum number of mirror hits, and of glass hits, of a path (scene or 2)."
      })
  private Optional<Integer> depth;

  @Mixin private final SampleFlags samples = new SampleFlags();

  @Mixin private final FrameFlags frame = new FrameFlags();

  @Mixin
  private final SettingFlags settings =
      new SettingFlags("", Group.TRANSPORT, Group.SAMPLING, Group.OUTPUT, Group.EXECUTION);

  /** Whether the layers for denoising are recorded besides those that are asked for. */
  private boolean isForDenoising;

  /** Sets the motion in one picture. */
  private Consumer<RenderSettings.Builder> exposure = settings -> {};

  /** The samples per pixel without a flag; empty for the samples of the scene. */
  private OptionalInt usualSamples = OptionalInt.empty();

  /**
   * Checks the ranges of the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    samples.validate();
    depth.ifPresent(n -> checks().requireIn("--depth", 0, RenderSettings.MAX_DEPTH, n));
    settings.validate(spec);
    frame.validate();
  }

  /** Returns the flags that select samples. */
  public SampleFlags samples() {
    return samples;
  }

  /**
   * Sets whether the layers for denoising are recorded besides those that are asked for.
   *
   * @param samples per pixel without a flag; empty for the samples of the scene
   */
  public void recordForDenoising(boolean isWanted, OptionalInt samples) {
    isForDenoising = isWanted;
    usualSamples = samples;
  }

  /** Sets the size of the frame without a flag, instead of that of the scene. */
  public void sizeUnlessGiven(FrameSize size) {
    frame.unlessGiven(size);
  }

  /** Sets the time of the shutter and the poses by flags of their own. */
  public void expose(Consumer<RenderSettings.Builder> byFlags) {
    exposure = byFlags;
  }

  /** Returns the layers that are asked for. */
  public Set<Layer> layers() {
    return settings.valueOr(Setting.LAYERS, Set.of());
  }

  /** Returns whether the scene is rendered in ray mode, if it is in path mode without flags. */
  public boolean isRayMode() {
    return mode.equals(Optional.of(Mode.RAY));
  }

  /** Returns whether the flags ask for an automatic exposure. */
  public boolean isExposureAutomatic() {
    return settings.valueOr(Setting.EXPOSURE, Exposure.NONE).equals(Exposure.AUTO);
  }

  /** Returns whether bright samples are clamped. */
  public boolean isClamping() {
    return settings.isGiven(Setting.CLAMP);
  }

  /** Returns a parser that overrides the scene's settings with the flags. */
  public SceneParser over(SceneParser parser) {
    return over(parser, false, false, OptionalInt.empty());
  }

  /**
   * Returns a parser that overrides the scene's settings with the flags.
   *
   * @param isOpen whether another limit ends the render and replaces the scene's samples
   * @param adaptive whether noisy pixels get more samples
   * @param pathDepth overrides the scene's depth in path mode
   */
  public SceneParser over(
      SceneParser parser, boolean isOpen, boolean adaptive, OptionalInt pathDepth) {
    SceneParser limited = frame.over(parser);
    return mode.map(limited::inMode)
        .orElse(limited)
        .overriding(inScene -> override(changed(inScene, isOpen, adaptive, pathDepth)));
  }

  private RenderSettings changed(
      RenderSettings inScene, boolean isOpen, boolean adaptive, OptionalInt pathDepth) {
    RenderSettings.Builder builder = inScene.toBuilder().adaptive(adaptive);
    exposure.accept(builder);
    usualSamples.ifPresent(n -> builder.samples(Math.max(n, forNoise(builder.build().poses()))));
    if (isOpen) {
      builder.samples(RenderSettings.MAX_SAMPLES);
    }
    pathDepth.ifPresent(builder::maxTraceDepth);
    return builder.build();
  }

  /** Returns the samples per pixel from which on the noise is known, which a denoiser needs. */
  private static int forNoise(int poses) {
    return poses == 1 ? 1 : 2 * poses;
  }

  private RenderSettings override(RenderSettings inScene) {
    RenderSettings.Builder builder = inScene.toBuilder();
    samples.override(builder);
    settings.override(builder);
    requirePathsFor(Setting.SPLIT, inScene.mode());
    requirePathsFor(Setting.GUIDE, inScene.mode());
    frame.override(builder, inScene);
    depth.ifPresent(n -> setDepth(builder, inScene.mode(), n));
    if (isForDenoising) {
      builder.set(Setting.LAYERS, withDenoising(builder.build().layers()));
    }
    return builder.build();
  }

  private static Set<Layer> withDenoising(Set<Layer> layers) {
    Set<Layer> all = EnumSet.copyOf(Layer.FOR_DENOISING);
    all.addAll(layers);
    return Layer.setOf(all.toArray(Layer[]::new));
  }

  private void requirePathsFor(Setting<?> setting, Mode mode) {
    require(
        mode == Mode.PATH || !settings.isGiven(setting),
        setting.flag() + ": requires path mode, found ray");
  }

  private static void setDepth(RenderSettings.Builder builder, Mode mode, int depth) {
    switch (mode) {
      case PATH -> builder.maxTraceDepth(depth);
      case RAY -> builder.rayDepths(depth, depth);
    }
  }
}
