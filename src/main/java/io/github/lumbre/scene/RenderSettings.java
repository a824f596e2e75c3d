package io.github.lumbre.scene;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * How a picture is to be made; the world itself is in {@link Scene}. Immutable; {@link #toBuilder}
 * begins a changed copy.
 *
 * @param width of the full frame in pixels, 1 to 65535
 * @param height of the full frame in pixels, 1 to 65535
 * @param mode ray tracing or path tracing
 * @param samples per pixel, 1 to 2^30, in whichever mode
 * @param maxTraceDepth path mode: how many vertices of a path may scatter
 * @param reflectionTraceDepth ray mode: how many mirrors a path may meet
 * @param refractionTraceDepth ray mode: how many glass surfaces a path may meet
 * @param threads 0 means as many as there are processors
 * @param bucketSize side of the square buckets in pixels
 * @param seed everything random follows from it
 * @param exposure applied when the picture is written with few bits
 * @param toneCurve applied when the picture is written with few bits
 * @param crop the part of the full frame to render; empty means all of it
 * @param transparent whether the share of samples that met something becomes the picture's alpha
 * @param adaptive whether the number of samples is the pixels' mean, and noisy pixels get more
 * @param split path mode: how many ways each path goes on from its first vertex that is no mirror
 *     or clear glass, 1 to 256, each for its share of the light
 * @param clamp above 0: samples of a larger component are darkened to it, which takes fireflies and
 *     light away; infinite for none
 */
public record RenderSettings(
    int width,
    int height,
    Mode mode,
    int samples,
    int maxTraceDepth,
    int reflectionTraceDepth,
    int refractionTraceDepth,
    int threads,
    int bucketSize,
    long seed,
    Exposure exposure,
    ToneCurve toneCurve,
    Optional<Crop> crop,
    boolean transparent,
    boolean adaptive,
    int split,
    double clamp) {

  /** The largest allowed width and height. */
  public static final int MAX_SIDE = 65535;

  /** The largest allowed number of samples per pixel. */
  public static final int MAX_SAMPLES = 1 << 30;

  /** The largest allowed depth, of each kind. */
  public static final int MAX_DEPTH = 1_000_000;

  /** The most ways in which a path may go on. */
  public static final int MAX_SPLIT = 256;

  /** The largest allowed number of threads. */
  public static final int MAX_THREADS = 1024;

  /** What a scene file that says nothing gets. */
  public static final RenderSettings DEFAULT = new Builder().build();

  public RenderSettings {
    requireIn(1, MAX_SIDE, width, "width");
    requireIn(1, MAX_SIDE, height, "height");
    requireIn(1, MAX_SAMPLES, samples, "samples");
    requireIn(0, MAX_DEPTH, maxTraceDepth, "maxTraceDepth");
    requireIn(0, MAX_DEPTH, reflectionTraceDepth, "reflectionTraceDepth");
    requireIn(0, MAX_DEPTH, refractionTraceDepth, "refractionTraceDepth");
    requireIn(0, MAX_THREADS, threads, "threads");
    requireIn(1, Integer.MAX_VALUE, bucketSize, "bucketSize");
    requireIn(1, MAX_SPLIT, split, "split");
    if (!(clamp > 0)) {
      throw new IllegalArgumentException("clamp: expected more than 0, found " + clamp);
    }
    Objects.requireNonNull(mode, "mode");
    Objects.requireNonNull(exposure, "exposure");
    Objects.requireNonNull(toneCurve, "toneCurve");
    Crop window = crop.orElse(new Crop(0, 0, 1, 1));
    if ((long) window.x + window.width > width || (long) window.y + window.height > height) {
      throw new IllegalArgumentException(
          "crop: expected inside " + width + "x" + height + ", found " + window);
    }
  }

  private static void requireIn(long low, long high, long found, String name) {
    if (found < low || found > high) {
      throw new IllegalArgumentException(
          name + ": expected " + low + " to " + high + ", found " + found);
    }
  }

  /** Returns the rectangle to render: the crop, or all of the frame. */
  public Crop window() {
    return crop.orElse(new Crop(0, 0, width, height));
  }

  /** Returns the width of the full frame over its height. */
  public double aspect() {
    return (double) width / height;
  }

  /**
   * Returns how a rendered picture is written to a file: with this exposure and this tone curve, in
   * 8 bits, without metadata. {@code lumbre render} writes the same pixels.
   */
  public ImageWriter.Options development() {
    return new ImageWriter.Options(exposure, toneCurve, 8, Map.of());
  }

  /** Returns a builder that begins with these settings. */
  public Builder toBuilder() {
    return new Builder(this);
  }

  /** Which light transport is computed. */
  public enum Mode {
    RAY,
    PATH
  }

  /**
   * A rectangle of the full frame, in pixels.
   *
   * @param x of its left column, at least 0
   * @param y of its top row, at least 0
   * @param width at least 1
   * @param height at least 1
   */
  public record Crop(int x, int y, int width, int height) {
    public Crop {
      requireIn(0, MAX_SIDE, x, "crop x");
      requireIn(0, MAX_SIDE, y, "crop y");
      requireIn(1, MAX_SIDE, width, "crop width");
      requireIn(1, MAX_SIDE, height, "crop height");
    }

    @Override
    public String toString() {
      return x + "," + y + "," + width + "," + height;
    }
  }

  /** Collects settings, beginning with the defaults or a copy. Mutable. */
  public static final class Builder {
    private int width = 1920;
    private int height = 1080;
    private Mode mode = Mode.PATH;
    private int samples = 100;
    private int maxTraceDepth = 5;
    private int reflectionTraceDepth = 2;
    private int refractionTraceDepth = 2;
    private int threads = 0;
    private int bucketSize = 32;
    private long seed = 0;
    private Exposure exposure = Exposure.NONE;
    private ToneCurve toneCurve = ToneCurve.SRGB;
    private Optional<Crop> crop = Optional.empty();
    private boolean transparent = false;
    private boolean adaptive = false;
    private int split = 1;
    private double clamp = Double.POSITIVE_INFINITY;

    public Builder() {}

    private Builder(RenderSettings from) {
      width = from.width;
      height = from.height;
      mode = from.mode;
      samples = from.samples;
      maxTraceDepth = from.maxTraceDepth;
      reflectionTraceDepth = from.reflectionTraceDepth;
      refractionTraceDepth = from.refractionTraceDepth;
      threads = from.threads;
      bucketSize = from.bucketSize;
      seed = from.seed;
      exposure = from.exposure;
      toneCurve = from.toneCurve;
      crop = from.crop;
      transparent = from.transparent;
      adaptive = from.adaptive;
      split = from.split;
      clamp = from.clamp;
    }

    public Builder size(int newWidth, int newHeight) {
      width = newWidth;
      height = newHeight;
      return this;
    }

    /** Sets how many mirrors and how many glass surfaces a path may meet in ray mode. */
    public Builder rayDepths(int reflection, int refraction) {
      reflectionTraceDepth = reflection;
      refractionTraceDepth = refraction;
      return this;
    }

    public Builder crop(Crop value) {
      crop = Optional.of(value);
      return this;
    }

    public Builder mode(Mode value) {
      mode = value;
      return this;
    }

    public Builder samples(int value) {
      samples = value;
      return this;
    }

    public Builder maxTraceDepth(int value) {
      maxTraceDepth = value;
      return this;
    }

    public Builder threads(int value) {
      threads = value;
      return this;
    }

    public Builder bucketSize(int value) {
      bucketSize = value;
      return this;
    }

    public Builder seed(long value) {
      seed = value;
      return this;
    }

    public Builder exposure(Exposure value) {
      exposure = value;
      return this;
    }

    public Builder toneCurve(ToneCurve value) {
      toneCurve = value;
      return this;
    }

    public Builder transparent(boolean value) {
      transparent = value;
      return this;
    }

    public Builder adaptive(boolean value) {
      adaptive = value;
      return this;
    }

    public Builder split(int value) {
      split = value;
      return this;
    }

    public Builder clamp(double value) {
      clamp = value;
      return this;
    }

    /**
     * @throws IllegalArgumentException naming the first setting that is out of range
     */
    public RenderSettings build() {
      return new RenderSettings(
          width,
          height,
          mode,
          samples,
          maxTraceDepth,
          reflectionTraceDepth,
          refractionTraceDepth,
          threads,
          bucketSize,
          seed,
          exposure,
          toneCurve,
          crop,
          transparent,
          adaptive,
          split,
          clamp);
    }
  }
}
