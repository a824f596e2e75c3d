package io.github.lumbre.scene;

import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.image.Dither;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The settings of a render: a value for each {@link Setting}, and the part of the frame to render.
 * The {@link Scene} is separate. Immutable; {@link #toBuilder} creates a modified copy.
 */
public final class RenderSettings {
  /** The largest allowed width and height. */
  public static final int MAX_SIDE = 65535;

  /** The largest allowed number of samples per pixel. */
  public static final int MAX_SAMPLES = 1 << 30;

  /** The largest allowed path depth, of each kind. */
  public static final int MAX_DEPTH = 1_000_000;

  /** The largest allowed number of branches of a split path. */
  public static final int MAX_SPLIT = 256;

  /** The longest allowed time of {@link Setting#SHUTTER}, in seconds. */
  public static final double MAX_SHUTTER = 3600;

  /** The largest allowed number of {@link Setting#POSES}. */
  public static final int MAX_POSES = 256;

  /** The largest allowed number of threads. */
  public static final int MAX_THREADS = 1024;

  /** The default settings. */
  public static final RenderSettings DEFAULT = new Builder().build();

  /** The values, indexed by {@link Setting#index}. */
  private final List<Object> values;

  private final Optional<Crop> crop;

  private RenderSettings(Builder from) {
    values = List.of(from.values);
    crop = from.crop;
    if (!new Crop(0, 0, width(), height()).contains(window())) {
      throw new IllegalArgumentException(
          "crop: expected a rectangle inside " + width() + "x" + height() + ", found " + window());
    }
  }

  private static void requireIn(long low, long high, long found, String name) {
    if (found < low || found > high) {
      throw new IllegalArgumentException(
          name + ": expected " + low + " to " + high + ", found " + found);
    }
  }

  /** Returns the value of a setting. */
  @SuppressWarnings("unchecked") // Builder.set is the only way in.
  public <T> T get(Setting<T> setting) {
    return (T) values.get(setting.index());
  }

  /** Returns whether the value of a setting differs from its default. */
  public boolean isSet(Setting<?> setting) {
    return !get(setting).equals(setting.defaultValue());
  }

  /** Returns the value of a setting as text, which {@link SettingType#parse} accepts. */
  public <T> String text(Setting<T> setting) {
    return setting.type().format(get(setting));
  }

  /** Returns {@link Setting#WIDTH}. */
  public int width() {
    return get(Setting.WIDTH);
  }

  /** Returns {@link Setting#HEIGHT}. */
  public int height() {
    return get(Setting.HEIGHT);
  }

  /** Returns {@link Setting#MODE}. */
  public Mode mode() {
    return get(Setting.MODE);
  }

  /** Returns {@link Setting#SAMPLES}. */
  public int samples() {
    return get(Setting.SAMPLES);
  }

  /** Returns {@link Setting#MAX_TRACE_DEPTH}. */
  public int maxTraceDepth() {
    return get(Setting.MAX_TRACE_DEPTH);
  }

  /** Returns {@link Setting#REFLECTION_TRACE_DEPTH}. */
  public int reflectionTraceDepth() {
    return get(Setting.REFLECTION_TRACE_DEPTH);
  }

  /** Returns {@link Setting#REFRACTION_TRACE_DEPTH}. */
  public int refractionTraceDepth() {
    return get(Setting.REFRACTION_TRACE_DEPTH);
  }

  /** Returns {@link Setting#THREADS}. */
  public int threads() {
    return get(Setting.THREADS);
  }

  /** Returns {@link Setting#BUCKET_SIZE}. */
  public int bucketSize() {
    return get(Setting.BUCKET_SIZE);
  }

  /** Returns {@link Setting#SEED}. */
  public long seed() {
    return get(Setting.SEED);
  }

  /** Returns {@link Setting#EXPOSURE}. */
  public Exposure exposure() {
    return get(Setting.EXPOSURE);
  }

  /** Returns {@link Setting#TONE_MAP}. */
  public ToneCurve toneCurve() {
    return get(Setting.TONE_MAP);
  }

  /** Returns {@link Setting#TRANSPARENT}. */
  public boolean transparent() {
    return get(Setting.TRANSPARENT);
  }

  /** Returns {@link Setting#BACKPLATE}; empty if {@link #transparent} returns true. */
  public Optional<Rgb> background() {
    return transparent() ? Optional.empty() : get(Setting.BACKPLATE);
  }

  /**
   * Returns whether a film counts the samples that hit something: the background is transparent, or
   * of a color that finished pictures show.
   */
  public boolean countsCoverage() {
    return transparent() || background().isPresent();
  }

  /** Returns {@link Setting#ADAPTIVE}. */
  public boolean adaptive() {
    return get(Setting.ADAPTIVE);
  }

  /** Returns {@link Setting#FILTER}. */
  public PixelFilter filter() {
    return get(Setting.FILTER);
  }

  /** Returns {@link Setting#SPLIT}. */
  public int split() {
    return get(Setting.SPLIT);
  }

  /** Returns {@link Setting#GUIDE}. */
  public Guiding guiding() {
    return get(Setting.GUIDE);
  }

  /** Returns {@link Setting#CLAMP}. */
  public double clamp() {
    return get(Setting.CLAMP);
  }

  /** Returns {@link Setting#LAYERS}. */
  public Set<Layer> layers() {
    return get(Setting.LAYERS);
  }

  /**
   * Returns the number of poses whose samples take turns: {@link Setting#POSES}, or 1 if {@link
   * Setting#SHUTTER} is 0.
   */
  public int poses() {
    return isSet(Setting.SHUTTER) ? get(Setting.POSES) : 1;
  }

  /**
   * Returns these settings with equally many samples of each pose: rounds the samples up to a
   * multiple of {@link #poses}.
   */
  public RenderSettings withWholePoses() {
    int rest = Math.floorMod(-samples(), poses());
    return rest == 0 ? this : toBuilder().samples(samples() + rest).build();
  }

  /** Returns the part of the full frame to render; empty means the full frame. */
  public Optional<Crop> crop() {
    return crop;
  }

  /** Returns the rectangle to render: the crop or the full frame. */
  public Crop window() {
    return crop.orElse(new Crop(0, 0, width(), height()));
  }

  /** Returns how far the middle of a row is down the full frame, from 0 to 1. */
  public double down(int row) {
    return (row + .5) / height();
  }

  /** Returns the width of the full frame divided by its height. */
  public double aspect() {
    return (double) width() / height();
  }

  /**
   * Returns the options for writing a rendered picture: this exposure, tone curve and background, 8
   * bits, dithered as a part of the full frame, no metadata. {@code lumbre render} writes the same
   * pixels.
   */
  public ImageWriter.Options development() {
    return new ImageWriter.Options(exposure(), toneCurve(), 8, Map.of())
        .withBackground(background())
        .withDither(Optional.of(window().dither()));
  }

  /** Returns a builder with the defaults. */
  public static Builder builder() {
    return new Builder();
  }

  /** Returns a builder with a copy of these settings. */
  public Builder toBuilder() {
    return new Builder(this);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RenderSettings that
        && values.equals(that.values)
        && crop.equals(that.crop);
  }

  @Override
  public int hashCode() {
    return Objects.hash(values, crop);
  }

  @Override
  public String toString() {
    return Setting.all().stream()
            .filter(this::isSet)
            .map(setting -> setting.name() + "=" + text(setting))
            .collect(Collectors.joining(", ", "RenderSettings[", ""))
        + crop.map(window -> ", crop=" + window).orElse("")
        + "]";
  }

  /** Whether paths are guided to where a pilot render found light. */
  public enum Guiding {
    /** There is no pilot render. */
    OFF,
    /** Paths are guided. */
    ON
  }

  /** The light transport algorithm. */
  public enum Mode {
    /** Whitted-style ray tracing. */
    RAY,
    /** Path tracing. */
    PATH
  }

  /**
   * The width and height of the full frame, in pixels.
   *
   * @param width at most nine digits; {@link Builder#size} limits it further
   * @param height at most nine digits
   */
  public record Size(int width, int height) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9})x(\\d{1,9})");

    /**
     * Returns the size in a text such as {@code 640x480}.
     *
     * @throws IllegalArgumentException if the text has another form
     */
    public static Size of(String text) {
      Matcher found = FORM.matcher(text);
      if (!found.matches()) {
        throw new IllegalArgumentException("expected WxH, such as 640x480, found '" + text + "'");
      }
      return new Size(Integer.parseInt(found.group(1)), Integer.parseInt(found.group(2)));
    }

    /** Returns the text that {@link #of} parses. */
    @Override
    public String toString() {
      return width + "x" + height;
    }
  }

  /**
   * A rectangle of the full frame, in pixels.
   *
   * @param x the left column, 0 to {@value #MAX_SIDE}
   * @param y the top row, 0 to {@value #MAX_SIDE}
   * @param width 1 to {@value #MAX_SIDE}
   * @param height 1 to {@value #MAX_SIDE}
   */
  public record Crop(int x, int y, int width, int height) {
    public Crop {
      requireIn(0, MAX_SIDE, x, "crop x");
      requireIn(0, MAX_SIDE, y, "crop y");
      requireIn(1, MAX_SIDE, width, "crop width");
      requireIn(1, MAX_SIDE, height, "crop height");
    }

    /** Returns the dithering of the rectangle's picture. */
    public Dither dither() {
      return new Dither(x, y);
    }

    /** Returns the number of pixels. */
    public long pixels() {
      return (long) width * height;
    }

    /** Returns whether all pixels of another rectangle are in this one. */
    public boolean contains(Crop other) {
      return other.x >= x
          && other.y >= y
          && other.x + other.width <= x + width
          && other.y + other.height <= y + height;
    }

    /** Java makes the default one at run time, which takes long at the start of a program. */
    @Override
    public boolean equals(Object other) {
      return other instanceof Crop crop
          && x == crop.x
          && y == crop.y
          && width == crop.width
          && height == crop.height;
    }

    @Override
    public int hashCode() {
      return 31 * (31 * (31 * x + y) + width) + height;
    }

    @Override
    public String toString() {
      return x + "," + y + "," + width + "," + height;
    }
  }

  /** Builds settings, starting from the defaults or a copy. Mutable. */
  public static final class Builder {
    private final Object[] values;
    private Optional<Crop> crop;

    /** Creates a builder with the defaults. */
    public Builder() {
      values = Setting.all().stream().map(Setting::defaultValue).toArray();
      crop = Optional.empty();
    }

    private Builder(RenderSettings from) {
      values = from.values.toArray();
      crop = from.crop;
    }

    /**
     * Sets a value.
     *
     * @throws IllegalArgumentException if the value is out of range; the message names the setting
     */
    public <T> Builder set(Setting<T> setting, T value) {
      values[setting.index()] = setting.require(value);
      return this;
    }

    /** Sets the size of the full frame in pixels. */
    public Builder size(int width, int height) {
      return set(Setting.WIDTH, width).set(Setting.HEIGHT, height);
    }

    /** Sets the maximum number of mirrors and of glass surfaces on a path in ray mode. */
    public Builder rayDepths(int reflection, int refraction) {
      return set(Setting.REFLECTION_TRACE_DEPTH, reflection)
          .set(Setting.REFRACTION_TRACE_DEPTH, refraction);
    }

    /**
     * Sets the part of the full frame to render; {@link #build} checks that it is inside the frame.
     */
    public Builder crop(Crop value) {
      crop = Optional.of(value);
      return this;
    }

    /** Sets {@link Setting#MODE}. */
    public Builder mode(Mode value) {
      return set(Setting.MODE, value);
    }

    /** Sets {@link Setting#SAMPLES}. */
    public Builder samples(int value) {
      return set(Setting.SAMPLES, value);
    }

    /** Sets {@link Setting#MAX_TRACE_DEPTH}. */
    public Builder maxTraceDepth(int value) {
      return set(Setting.MAX_TRACE_DEPTH, value);
    }

    /** Sets {@link Setting#THREADS}. */
    public Builder threads(int value) {
      return set(Setting.THREADS, value);
    }

    /** Sets {@link Setting#BUCKET_SIZE}. */
    public Builder bucketSize(int value) {
      return set(Setting.BUCKET_SIZE, value);
    }

    /** Sets {@link Setting#SEED}. */
    public Builder seed(long value) {
      return set(Setting.SEED, value);
    }

    /** Sets {@link Setting#EXPOSURE}. */
    public Builder exposure(Exposure value) {
      return set(Setting.EXPOSURE, value);
    }

    /** Sets {@link Setting#TONE_MAP}. */
    public Builder toneCurve(ToneCurve value) {
      return set(Setting.TONE_MAP, value);
    }

    /** Sets {@link Setting#TRANSPARENT}. */
    public Builder transparent(boolean value) {
      return set(Setting.TRANSPARENT, value);
    }

    /** Sets {@link Setting#ADAPTIVE}. */
    public Builder adaptive(boolean value) {
      return set(Setting.ADAPTIVE, value);
    }

    /** Sets {@link Setting#FILTER}. */
    public Builder filter(PixelFilter value) {
      return set(Setting.FILTER, value);
    }

    /** Sets {@link Setting#SPLIT}. */
    public Builder split(int value) {
      return set(Setting.SPLIT, value);
    }

    /** Sets {@link Setting#GUIDE}. */
    public Builder guiding(Guiding value) {
      return set(Setting.GUIDE, value);
    }

    /** Sets {@link Setting#CLAMP}. */
    public Builder clamp(double value) {
      return set(Setting.CLAMP, value);
    }

    /**
     * Returns the settings.
     *
     * @throws IllegalArgumentException if the crop is not inside the frame
     */
    public RenderSettings build() {
      return new RenderSettings(this);
    }
  }
}
