package io.github.lumbre.scene;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A quantity that a render records for each pixel besides its light, from the same paths: an AOV
 * (arbitrary output variable). The picture does not depend on it.
 *
 * <p>The <i>first surface</i> is the first one that the camera ray hits; transparent surfaces that
 * the ray passes do not count. {@link #ALBEDO}, normals and light are means over all samples, so
 * that they are 0 where nothing is hit. {@link #POSITION}, {@link #DEPTH} and {@link #UV} are means
 * over the samples that hit a surface; they are 0 in pixels without any.
 */
public enum Layer {
  /** Color of the first surface at normal incidence, in [0,1]; of lights, at most 1. */
  ALBEDO("albedo", "R G B"),

  /**
   * Shading normal of the first surface, on the side of the camera: world space, of length 1 before
   * the mean.
   */
  NORMAL("normal", "X Y Z"),

  /** Normal of the true first surface, without smoothing and normal maps; see {@link #NORMAL}. */
  GEOMETRIC_NORMAL("geometricNormal", "X Y Z"),

  /** Position on the first surface, in world space; each coordinate is limited to ±2^31. */
  POSITION("position", "X Y Z"),

  /** Distance from the camera to the first surface along the ray, in world units, up to 2^31. */
  DEPTH("depth", "Z"),

  /** Texture coordinates of the first surface, limited to ±2^31. */
  UV("uv", "U V"),

  /** The objects of the first surface, each with its share of the samples. */
  OBJECT("object", ""),

  /** The materials of the first surface, each with its share of the samples. */
  MATERIAL("material", ""),

  /** The number of samples. */
  SAMPLES("samples", "N"),

  /**
   * An estimate of the variance of the pixel's light, from the halves of its samples; negative
   * where it is not known.
   */
  VARIANCE("variance", "R G B"),

  /** Light that was scattered at most once: visible lights and direct light. */
  DIRECT("direct", "R G B"),

  /** Light that was scattered more than once: the picture minus {@link #DIRECT}. */
  INDIRECT("indirect", "R G B"),

  /**
   * The light of each light group of the scene, and of all lights without a group. Together they
   * are the picture.
   */
  LIGHTS("lights", "R G B"),

  /**
   * The {@link #ALBEDO} for denoisers: seen through mirrors and clear glass, tinted by them. In the
   * background, its color, at most 1; black if it is transparent.
   */
  DENOISING_ALBEDO("denoisingAlbedo", "R G B"),

  /** The {@link #NORMAL} for denoisers: seen through mirrors and clear glass. */
  DENOISING_NORMAL("denoisingNormal", "X Y Z"),

  /**
   * Alpha for denoisers, in [0,1]. Where the ground shows its shadow alone, several shadow rays for
   * each sample tell how dark it is, while {@code alpha} counts the samples in shadow; what lies
   * below the ground is taken as nothing there. Recorded only in scenes with such a ground.
   */
  DENOISING_ALPHA("denoisingAlpha", "A");

  /** The text for all layers. */
  public static final String ALL = "all";

  /** The text for the layers that denoisers use. */
  public static final String DENOISE = "denoise";

  /** The layers that denoisers use. */
  public static final Set<Layer> FOR_DENOISING =
      setOf(VARIANCE, DENOISING_ALBEDO, DENOISING_NORMAL, DENOISING_ALPHA);

  private final String text;
  private final List<String> channels;

  Layer(String text, String channels) {
    this.text = text;
    this.channels = channels.isEmpty() ? List.of() : List.of(channels.split(" "));
  }

  /** Returns the name, such as {@code geometricNormal}: in files and on the command line. */
  public String text() {
    return text;
  }

  /** Returns the names of the channels in OpenEXR files; empty for ids. */
  public List<String> channels() {
    return channels;
  }

  /** Returns the layer with a name; empty if there is none. */
  public static Optional<Layer> named(String text) {
    return Arrays.stream(values()).filter(layer -> layer.text.equals(text)).findFirst();
  }

  /** Returns an unmodifiable set in the order of declaration. */
  public static Set<Layer> setOf(Layer... layers) {
    EnumSet<Layer> set = EnumSet.noneOf(Layer.class);
    set.addAll(Arrays.asList(layers));
    return Collections.unmodifiableSet(set);
  }

  @Override
  public String toString() {
    return text;
  }
}
