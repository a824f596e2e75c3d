package io.github.lumbre.scene;

import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import io.github.lumbre.scene.internal.SettingTypes.ExposureType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.IntegerType;
import io.github.lumbre.scene.internal.SettingTypes.LayersType;
import io.github.lumbre.scene.internal.SettingTypes.LimitType;
import io.github.lumbre.scene.internal.SettingTypes.LongType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scene.internal.SettingTypes.PowerType;
import io.github.lumbre.scene.internal.SettingTypes.ScreenColorType;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A setting of a render, with its name, values, default and meaning. This class is the only
 * declaration. Scene files, command line flags, checkpoint files, picture metadata and JSON
 * summaries all use it. A new setting needs a new constant and the code that applies it. Immutable
 * after its declaration.
 *
 * @param <T> the type of its values
 */
public final class Setting<T> {
  private static final List<Setting<?>> ALL = new ArrayList<>();

  private static final IntegerType SIDE = new IntegerType(1, RenderSettings.MAX_SIDE);
  private static final IntegerType DEPTH = new IntegerType(0, RenderSettings.MAX_DEPTH);

  /** Width of the full frame in pixels. */
  public static final Setting<Integer> WIDTH =
      new Setting<>("width", Group.FRAME, SIDE, 1920, "Width of the full frame in pixels.")
          .inScenes()
          .changingSamples();

  /** Height of the full frame in pixels. */
  public static final Setting<Integer> HEIGHT =
      new Setting<>("height", Group.FRAME, SIDE, 1080, "Height of the full frame in pixels.")
          .inScenes()
          .changingSamples();

  /** Whether the fraction of samples that hit a surface becomes the picture's alpha. */
  public static final Setting<Boolean> TRANSPARENT =
      new Setting<>(
              "transparent",
              Group.FRAME,
              new FlagType(),
              false,
              "Whether the share of samples that hit something becomes the picture's alpha.")
          .changingSamples();

  /**
   * The color of the screen, as a linear color, that finished pictures show where no sample hits
   * anything; empty if they show the light of the scene there. Samples find the light of the color
   * there, and behind clear glass. Without effect if {@link #TRANSPARENT} is set.
   */
  public static final Setting<Optional<Rgb>> BACKPLATE =
      new Setting<>(
              "backplate",
              Group.FRAME,
              new ScreenColorType(),
              Optional.<Rgb>empty(),
              "Color of the screen where no sample hits anything.")
          .inScenes()
          .changingSamples();

  /** The light transport algorithm. */
  public static final Setting<RenderSettings.Mode> MODE =
      new Setting<>(
              "mode",
              Group.TRANSPORT,
              new ChoiceType<>(RenderSettings.Mode.class),
              RenderSettings.Mode.PATH,
              "ray: classic ray tracing (Whitted); path: path tracing, all light.")
          .inScenes()
          .changingSamples();

  /** Path mode: the maximum number of scattering vertices of a path. */
  public static final Setting<Integer> MAX_TRACE_DEPTH =
      new Setting<>(
              "maxTraceDepth",
              Group.TRANSPORT,
              DEPTH,
              5,
              "Path mode: how many vertices of a path may scatter.")
          .inScenes()
          .changingSamples();

  /** Ray mode: the maximum number of mirrors on a path. */
  public static final Setting<Integer> REFLECTION_TRACE_DEPTH =
      new Setting<>(
              "reflectionTraceDepth",
              Group.TRANSPORT,
              DEPTH,
              2,
              "Ray mode: how many mirrors a path may hit.")
          .inScenes()
          .changingSamples();

  /** Ray mode: the maximum number of glass surfaces on a path. */
  public static final Setting<Integer> REFRACTION_TRACE_DEPTH =
      new Setting<>(
              "refractionTraceDepth",
              Group.TRANSPORT,
              DEPTH,
              2,
              "Ray mode: how many glass surfaces a path may hit.")
          .inScenes()
          .changingSamples();

  /**
   * Path mode: the number of branches into which a path is split at its first non-specular surface.
   */
  public static final Setting<Integer> SPLIT =
      new Setting<>(
              "split",
              Group.TRANSPORT,
              new IntegerType(1, RenderSettings.MAX_SPLIT),
              1,
              "Path mode: split each path into N branches at its first surface that is not a mirror"
                  + " or clear glass. Less noise in the same time where indirect light dominates.")
          .withFlag("--split", "N")
          .changingSamples();

  /** Path mode: whether a pilot render learns where light comes from, and guides paths there. */
  public static final Setting<RenderSettings.Guiding> GUIDE =
      new Setting<>(
              "guide",
              Group.TRANSPORT,
              new ChoiceType<>(RenderSettings.Guiding.class),
              RenderSettings.Guiding.OFF,
              "Path mode: off or on. Learn in a pilot render where light comes from, and guide"
                  + " paths there. Less noise where little light is found by chance, such as behind"
                  + " a door; more noise in most other scenes.")
          .withFlag("--guide", "MODE")
          .changingSamples();

  /**
   * The largest allowed RGB component of a sample. Brighter samples are scaled down, which biases
   * the result.
   */
  public static final Setting<Double> CLAMP =
      new Setting<>(
              "clamp",
              Group.TRANSPORT,
              new LimitType(),
              Double.POSITIVE_INFINITY,
              "Scale brighter samples down to this largest component: fewer fireflies, but light is"
                  + " lost; the summary reports how much. Not with a checkpoint file.")
          .withFlag("--clamp", "VALUE")
          .changingSamples();

  /** Samples per pixel, in either mode. */
  public static final Setting<Integer> SAMPLES =
      new Setting<>(
              "samples",
              Group.SAMPLING,
              new IntegerType(1, RenderSettings.MAX_SAMPLES),
              100,
              "Samples per pixel.")
          .inScenes();

  /** Whether noisy pixels receive more samples; {@link #SAMPLES} is then the mean per pixel. */
  public static final Setting<Boolean> ADAPTIVE =
      new Setting<>(
          "adaptive",
          Group.SAMPLING,
          new FlagType(),
          false,
          "Whether noisy pixels receive more of the samples.");

  /** The pixel reconstruction filter. */
  public static final Setting<PixelFilter> FILTER =
      new Setting<>(
              "filter",
              Group.SAMPLING,
              new ChoiceType<>(PixelFilter.class),
              PixelFilter.BOX,
              "Pixel reconstruction filter: box, tent, gaussian or blackman-harris.")
          .inScenes()
          .withFlag("--filter", "NAME")
          .changingSamples();

  /**
   * The time in seconds during which the animated models of a scene move for one picture, from the
   * time of their pose on; 0 for a still picture.
   */
  public static final Setting<Double> SHUTTER =
      new Setting<>(
              "shutter",
              Group.SAMPLING,
              new NumberType(0, RenderSettings.MAX_SHUTTER),
              0.,
              "Seconds during which animated models move for one picture; 0: they stand still.")
          .inScenes()
          .changingSamples();

  /** The number of poses that stand for the motion during {@link #SHUTTER}. */
  public static final Setting<Integer> POSES =
      new Setting<>(
              "poses",
              Group.SAMPLING,
              new PowerType(RenderSettings.MAX_POSES),
              16,
              "Poses, a power of two, that stand for the motion during the time of the shutter.")
          .inScenes()
          .changingSamples();

  /** Seed of all random numbers. */
  public static final Setting<Long> SEED =
      new Setting<>("seed", Group.SAMPLING, new LongType(), 0L, "Seed of all random numbers.")
          .inScenes()
          .withFlag("--seed", "N")
          .changingSamples();

  /** The exposure of pictures with a tone curve, such as PNG, in stops. */
  public static final Setting<Exposure> EXPOSURE =
      new Setting<>(
              "exposure",
              Group.OUTPUT,
              new ExposureType(),
              Exposure.NONE,
              "Stops by which a PNG is brightened, or auto.")
          .inScenes()
          .withFlag("--exposure", "EV");

  /** The tone curve of low dynamic range pictures, such as PNG. */
  public static final Setting<ToneCurve> TONE_MAP =
      new Setting<>(
              "toneMap",
              Group.OUTPUT,
              new ChoiceType<>(ToneCurve.class),
              ToneCurve.SRGB,
              "Tone curve of a PNG: srgb, gamma22, reinhard, aces, neutral or agx.")
          .inScenes()
          .inModels(ToneCurve.NEUTRAL)
          .withFlag("--tonemap", "NAME");

  /** The width in pixels of the lines that are drawn on a finished picture; 0 for no lines. */
  public static final Setting<Double> LINE_WIDTH =
      new Setting<>(
              "lineWidth",
              Group.OUTPUT,
              new NumberType(0, 100),
              0.,
              "Width in pixels of lines on silhouettes, creases and borders of meshes; 0: none.")
          .inScenes();

  /** The angle between two triangles from which on their edge is a crease, in degrees. */
  public static final Setting<Double> CREASE_ANGLE =
      new Setting<>(
              "creaseAngle",
              Group.OUTPUT,
              new NumberType(0, 180),
              30.,
              "Degrees between two triangles from which on a line is drawn along their edge.")
          .inScenes();

  /** What the render records besides the picture. */
  public static final Setting<Set<Layer>> LAYERS =
      new Setting<>(
              "layers",
              Group.OUTPUT,
              new LayersType(),
              Set.of(),
              "Layers (AOVs) to record besides the picture, separated by commas; all, denoise, or"
                  + " some of albedo, normal, geometricNormal, position, depth, uv, object,"
                  + " material, samples, variance, direct, indirect, lights, denoisingAlbedo,"
                  + " denoisingNormal. An .exr picture or a checkpoint holds them.")
          .withFlag("--layers", "NAMES");

  /** Number of threads; 0 means one for each processor. */
  public static final Setting<Integer> THREADS =
      new Setting<>(
              "threads",
              Group.EXECUTION,
              new IntegerType(0, RenderSettings.MAX_THREADS),
              0,
              "Threads; 0 means one for each processor. The picture is the same.")
          .inScenes()
          .withFlag("--threads", "N");

  /** Side of the square buckets in pixels. */
  public static final Setting<Integer> BUCKET_SIZE =
      new Setting<>(
              "bucketSize",
              Group.EXECUTION,
              new IntegerType(1, Integer.MAX_VALUE),
              32,
              "Side in pixels of the squares that threads render. The picture is the same.")
          .inScenes()
          .withFlag("--bucket", "N");

  private final int index;
  private final String name;
  private final Group group;
  private final SettingType<T> type;
  private final T defaultValue;
  private final String meaning;
  private boolean inScenes;
  private Optional<T> inModels = Optional.empty();
  private boolean changesSamples;
  private String flag = "";
  private String label = "";

  /** The subject of a setting, in the order of the help texts. */
  public enum Group {
    /** Size and background of the picture. */
    FRAME,
    /** The light transport algorithm and its limits. */
    TRANSPORT,
    /** The number and distribution of samples, and the random numbers. */
    SAMPLING,
    /** How the picture is tone mapped and written. */
    OUTPUT,
    /** How the work is divided; the picture does not depend on it. */
    EXECUTION
  }

  private Setting(String name, Group group, SettingType<T> type, T defaultValue, String meaning) {
    this.name = name;
    this.group = group;
    this.type = type;
    this.defaultValue = defaultValue;
    this.meaning = meaning;
    index = ALL.size();
    ALL.add(this);
  }

  private Setting<T> inScenes() {
    inScenes = true;
    return this;
  }

  private Setting<T> inModels(T value) {
    inModels = Optional.of(value);
    return this;
  }

  private Setting<T> changingSamples() {
    changesSamples = true;
    return this;
  }

  private Setting<T> withFlag(String newFlag, String newLabel) {
    flag = newFlag;
    label = newLabel;
    return this;
  }

  /** Returns all settings, in the order of their declaration. */
  public static List<Setting<?>> all() {
    return List.copyOf(ALL);
  }

  /** Returns the index of this setting in {@link #all}. */
  int index() {
    return index;
  }

  /** Returns the name, which is the key in {@code renderOptions} and in checkpoint files. */
  public String name() {
    return name;
  }

  /** Returns the subject of the setting. */
  public Group group() {
    return group;
  }

  /** Returns the type, which defines the allowed values and their text form. */
  public SettingType<T> type() {
    return type;
  }

  /** Returns the default value. */
  public T defaultValue() {
    return defaultValue;
  }

  /** Returns a description for help texts, without the default value. */
  public String meaning() {
    return meaning;
  }

  /** Returns whether scene files may contain this setting in {@code renderOptions}. */
  public boolean isInScenes() {
    return inScenes;
  }

  /** Returns the default value for models; empty if it is the one for scenes. */
  public Optional<T> inModels() {
    return inModels;
  }

  /**
   * Returns whether sample values depend on this setting. Films that differ in it cannot be merged.
   */
  public boolean changesSamples() {
    return changesSamples;
  }

  /** Returns the command line flag; an empty string if no flag sets only this setting. */
  public String flag() {
    return flag;
  }

  /** Returns the placeholder of the flag's value in help texts; empty without a flag. */
  public String label() {
    return label;
  }

  /**
   * Returns the value if it is in range.
   *
   * @throws IllegalArgumentException if it is not; the message names the setting, the expected
   *     range and the value
   */
  T require(T value) {
    return type.require(name, value);
  }

  @Override
  public String toString() {
    return name;
  }
}
