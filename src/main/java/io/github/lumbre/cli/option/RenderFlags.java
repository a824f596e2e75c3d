package io.github.lumbre.cli.option;

import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.Setting.Group;
import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flags that override a scene's render settings. */
public final class RenderFlags {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--mode",
      paramLabel = "MODE",
      converter = FlagConverters.OfMode.class,
      description = "Render mode: ray (Whitted) or path (path tracing). Default: scene or path.")
  private Optional<Mode> mode;

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description = "Samples per pixel (scene or 100).")
  private Optional<Integer> samples;

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

  /** Whether the layers for denoising are recorded besides those that are asked for. */
  private boolean isForDenoising;

  /** The index of the first sample of the share, once the scene's number of samples is known. */
  private int firstOfShare;

  @Option(
      names = "--depth",
      paramLabel = "N",
      description = {
        "Path mode: maximum number of scattering vertices of a path (scene or 5; models: 12).",
        "Ray mode: maximum number of mirror hits, and of glass hits, of a path (scene or 2)."
      })
  private Optional<Integer> depth;

  @Mixin
  SettingFlags settings =
      new SettingFlags("", Group.TRANSPORT, Group.SAMPLING, Group.OUTPUT, Group.EXECUTION);

  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = FlagConverters.OfSize.class,
      description =
          "Size of the full frame in pixels (scene or 1920x1080; models: 1024 for the longer"
              + " side, with the aspect ratio of the camera, or 1024x768).")
  private Optional<Size> size;

  @Option(
      names = "--crop",
      paramLabel = "x,y,w,h",
      converter = FlagConverters.OfCrop.class,
      description = "Render only this window of the full frame, with the same pixel values.")
  private Optional<Crop> crop;

  @Option(
      names = "--max-pixels",
      paramLabel = "N",
      description = "Reject frames with more pixels (268435456, which is 2^28).")
  private Optional<Integer> maxPixels;

  /**
   * Checks the ranges of the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    samples.ifPresent(n -> require("--samples", 1, RenderSettings.MAX_SAMPLES, n));
    samplesFrom.ifPresent(n -> require("--samples-from", 0, RenderSettings.MAX_SAMPLES - 1, n));
    samplesTo.ifPresent(
        n -> require("--samples-to", firstSample() + 1, RenderSettings.MAX_SAMPLES, n));
    if (samples.isPresent() && samplesTo.isPresent()) {
      throw new ParameterException(
          spec.commandLine(), "--samples and --samples-to: expected only one of them");
    }
    share();
    if (share.isPresent() && (samplesFrom.isPresent() || samplesTo.isPresent())) {
      throw new ParameterException(
          spec.commandLine(),
          "--share: cannot be combined with --samples-from or --samples-to, which select samples"
              + " too");
    }
    depth.ifPresent(n -> require("--depth", 0, RenderSettings.MAX_DEPTH, n));
    settings.validate(spec);
    maxPixels.ifPresent(n -> require("--max-pixels", 1, SceneParser.MAX_PIXELS_EVER, n));
    size.ifPresent(s -> require("--size", 1, RenderSettings.MAX_SIDE, s.width()));
    size.ifPresent(s -> require("--size", 1, RenderSettings.MAX_SIDE, s.height()));
    size.ifPresent(s -> requireCropIn(s.width(), s.height()));
  }

  /** Records the layers for denoising besides those that are asked for. */
  public void recordForDenoising() {
    isForDenoising = true;
  }

  /** Returns whether layers are asked for. */
  public boolean hasLayers() {
    return settings.isGiven(Setting.LAYERS)
        && !settings.valueOr(Setting.LAYERS, Set.of()).isEmpty();
  }

  /** Returns whether bright samples are clamped. */
  public boolean isClamping() {
    return settings.isGiven(Setting.CLAMP);
  }

  /** Returns whether the flags select a range of sample indices. */
  public boolean hasSampleRange() {
    return samplesFrom.isPresent() || samplesTo.isPresent() || share.isPresent();
  }

  /** Returns whether the flags select a share of the samples. */
  public boolean hasShare() {
    return share.isPresent();
  }

  /** Returns the index of each pixel's first sample; of a share, once the scene is read. */
  public int firstSample() {
    return share.isPresent() ? firstOfShare : samplesFrom.orElse(0);
  }

  private Optional<Share> share() {
    try {
      return share.map(text -> Share.parse(text, System.getenv()));
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--share: " + e.getMessage(), e);
    }
  }

  /** Limits the samples to the share. */
  private void select(Share part, RenderSettings.Builder builder) {
    int all = builder.build().samples();
    try {
      firstOfShare = part.first(all);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--share: " + e.getMessage(), e);
    }
    builder.samples(part.end(all) - firstOfShare);
  }

  private void require(String flag, int low, int high, int found) {
    if (found < low || found > high) {
      throw new ParameterException(
          spec.commandLine(), flag + ": expected " + low + " to " + high + ", found " + found);
    }
  }

  private void requireCropIn(int width, int height) {
    Crop window = crop.orElse(new Crop(0, 0, 1, 1));
    boolean inside =
        (long) window.x() + window.width() <= width
            && (long) window.y() + window.height() <= height;
    if (!inside) {
      throw new ParameterException(
          spec.commandLine(),
          "--crop: expected a part of " + width + "x" + height + ", found " + window);
    }
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
    SceneParser limited = maxPixels.map(parser::limitedTo).orElse(parser);
    return mode.map(limited::inMode)
        .orElse(limited)
        .overriding(inScene -> override(changed(inScene, isOpen, adaptive, pathDepth)));
  }

  private static RenderSettings changed(
      RenderSettings inScene, boolean isOpen, boolean adaptive, OptionalInt pathDepth) {
    RenderSettings.Builder builder = inScene.toBuilder().adaptive(adaptive);
    if (isOpen) {
      builder.samples(RenderSettings.MAX_SAMPLES);
    }
    pathDepth.ifPresent(builder::maxTraceDepth);
    return builder.build();
  }

  private RenderSettings override(RenderSettings inScene) {
    RenderSettings.Builder builder = inScene.toBuilder();
    samples.ifPresent(builder::samples);
    samplesTo.ifPresent(n -> builder.samples(n - firstSample()));
    share().ifPresent(part -> select(part, builder));
    settings.override(builder);
    requirePathsFor(Setting.SPLIT, inScene.mode());
    requirePathsFor(Setting.GUIDE, inScene.mode());
    size.ifPresent(s -> builder.size(s.width(), s.height()));
    depth.ifPresent(n -> setDepth(builder, inScene.mode(), n));
    if (size.isEmpty()) {
      requireCropIn(inScene.width(), inScene.height());
    }
    crop.ifPresent(builder::crop);
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
    if (mode == Mode.RAY && settings.isGiven(setting)) {
      throw new ParameterException(
          spec.commandLine(), setting.flag() + ": requires path mode, found ray");
    }
  }

  private static void setDepth(RenderSettings.Builder builder, Mode mode, int depth) {
    switch (mode) {
      case PATH -> builder.maxTraceDepth(depth);
      case RAY -> builder.rayDepths(depth, depth);
    }
  }
}
