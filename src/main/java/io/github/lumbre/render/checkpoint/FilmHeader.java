package io.github.lumbre.render.checkpoint;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The header of a film: the scene and settings of its samples, and which samples it has.
 *
 * @param identity everything on which the samples depend, as texts by name. Films with equal
 *     identities belong to the same picture, and their samples may be added
 * @param hasAlpha whether the film counts the samples that cover each pixel
 * @param window the film's window in the full frame
 * @param layers the layers that the film records besides the picture
 * @param parts the samples of the film, in parts that do not overlap; usually one part
 * @param faults numbers of rejected and of saturated samples, and the positions of the first
 *     rejected ones; all other statistics are dropped
 * @param notes further information, as texts by name, such as the path of the scene
 */
public record FilmHeader(
    Map<String, String> identity,
    boolean hasAlpha,
    Crop window,
    RecordedLayers layers,
    List<FilmPart> parts,
    RenderStatistics faults,
    Map<String, String> notes) {
  /** Name in the identity: SHA-256 hash of the scene and of every file that it uses. */
  public static final String SCENE_HASH = "scene-hash";

  /** Name in the identity: path tracing or ray tracing. */
  public static final String MODE = "mode";

  /**
   * Name in the identity: the trace depth. One number for path tracing; two numbers, reflections
   * and refractions, for ray tracing.
   */
  public static final String DEPTH = "depth";

  /** Name in the identity: the seed of all random numbers. */
  public static final String SEED = "seed";

  /** Name in the identity: width and height of the whole picture. */
  public static final String SIZE = "size";

  /** Name in the identity: whether the background is transparent. */
  public static final String TRANSPARENT = "transparent";

  /** Name in the identity: the kind of random numbers. */
  public static final String SAMPLER = "sampler";

  /** Name in the identity: {@link FilmRenderer#REVISION}. */
  public static final String REVISION = "revision";

  /**
   * Name in the identity: hash of the guide of a pilot render, with {@link Setting#GUIDE}. It is
   * known once the pilot is rendered.
   */
  public static final String GUIDE_HASH = "guide-hash";

  /** Name in the identity: hash of the model that an installed program has made of the file. */
  public static final String CONVERTED_HASH = "converted-model-hash";

  private static final String NOTHING = "nothing";

  /** The settings that every identity contains in an entry with its own format. */
  private static final Set<Setting<?>> COMBINED =
      Set.of(
          Setting.MODE,
          Setting.MAX_TRACE_DEPTH,
          Setting.REFLECTION_TRACE_DEPTH,
          Setting.REFRACTION_TRACE_DEPTH,
          Setting.SEED,
          Setting.WIDTH,
          Setting.HEIGHT,
          Setting.TRANSPARENT);

  public FilmHeader {
    identity = Collections.unmodifiableMap(new LinkedHashMap<>(identity));
    notes = Collections.unmodifiableMap(new LinkedHashMap<>(notes));
    parts = List.copyOf(parts);
    faults = faults.faults();
  }

  /** Returns the identity of a render: everything on which its samples depend. */
  public static Map<String, String> identity(String sceneHash, RenderSettings settings) {
    Map<String, String> identity = new LinkedHashMap<>();
    identity.put(SCENE_HASH, sceneHash);
    identity.put(MODE, settings.mode().name().toLowerCase(Locale.ROOT));
    identity.put(DEPTH, depth(settings));
    for (Setting<?> setting : named()) {
      if (settings.isSet(setting)) {
        identity.put(setting.name(), settings.text(setting));
      }
    }
    identity.put(SEED, String.valueOf(settings.seed()));
    identity.put(SIZE, settings.width() + "x" + settings.height());
    identity.put(TRANSPARENT, String.valueOf(settings.transparent()));
    identity.put(SAMPLER, SobolSampler.ID);
    identity.put(REVISION, String.valueOf(FilmRenderer.REVISION));
    return identity;
  }

  /**
   * Returns an empty film of a window, with the layers and the poses of this header.
   *
   * @throws ArithmeticException if its layers are too large for its window
   * @throws IllegalArgumentException if the identity has an invalid number of poses or backplate,
   *     or the first sample is not the first of a round of poses
   */
  Film newFilm(Crop ofWindow, int firstSample) {
    return new Film(ofWindow, hasAlpha, firstSample, layers.ofFilm(), poses(), background());
  }

  /**
   * Returns the color of the screen that finished pictures show behind what the samples hit.
   *
   * @throws IllegalArgumentException if the identity has an invalid color
   */
  public Optional<Rgb> background() {
    return Boolean.parseBoolean(identity.get(TRANSPARENT))
        ? Optional.empty()
        : Setting.BACKPLATE
            .type()
            .parse(identity.getOrDefault(Setting.BACKPLATE.name(), ""));
  }

  private int poses() {
    return identity.containsKey(Setting.SHUTTER.name())
        ? Setting.POSES
            .type()
            .parse(identity.getOrDefault(Setting.POSES.name(), missing(Setting.POSES.name())))
        : 1;
  }

  /**
   * Returns the settings that an identity contains under their own names, unless they have their
   * default values.
   */
  public static List<Setting<?>> named() {
    return Setting.all().stream()
        .filter(setting -> setting.changesSamples() && !COMBINED.contains(setting))
        .toList();
  }

  /**
   * Returns the value of a name that an identity lacks: the default of the setting, or "nothing".
   */
  private static String missing(String name) {
    return named().stream()
        .filter(setting -> setting.name().equals(name))
        .map(setting -> RenderSettings.DEFAULT.text(setting))
        .findAny()
        .orElse(NOTHING);
  }

  /** Returns a value for messages, with long hashes shortened. */
  private static String shown(String value) {
    return value.length() == 64 ? value.substring(0, 12) + "…" : value;
  }

  private static String depth(RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH -> String.valueOf(settings.maxTraceDepth());
      case RAY -> settings.reflectionTraceDepth() + "," + settings.refractionTraceDepth();
    };
  }

  /** Returns the same header with another window, other parts and other faults. */
  FilmHeader withParts(Crop newWindow, List<FilmPart> newParts, RenderStatistics newFaults) {
    return new FilmHeader(identity, hasAlpha, newWindow, layers, newParts, newFaults, notes);
  }

  /**
   * Returns whether samples are missing between the samples of the film: they are not consecutive,
   * or some pixels of the window lack samples that others have.
   */
  public boolean hasGaps() {
    return parts.size() != 1 || !parts.get(0).window().equals(window);
  }

  /** Returns the same header with other notes. */
  public FilmHeader withNotes(Map<String, String> newNotes) {
    return new FilmHeader(identity, hasAlpha, window, layers, parts, faults, newNotes);
  }

  /**
   * Requires that another film has the layers of this one.
   *
   * @param here name of this film, for the message
   * @param there name of the other film
   */
  void requireSameLayers(FilmHeader other, String here, String there) throws FilmMismatchException {
    if (!other.layers.equals(layers)) {
      throw new FilmMismatchException(
          "layers: %s has %s, %s has %s"
              .formatted(here, shown(layers), there, shown(other.layers)));
    }
  }

  private static String shown(RecordedLayers layers) {
    return layers.isEmpty() ? NOTHING : Setting.LAYERS.type().format(layers.kinds());
  }

  /**
   * Requires that another identity equals this one.
   *
   * @param here name of the owner of this header, for the message
   * @param there name of the owner of the other identity
   * @throws FilmMismatchException if they differ, with all differences in the message
   */
  public void requireSame(Map<String, String> other, String here, String there)
      throws FilmMismatchException {
    Set<String> names = new LinkedHashSet<>(identity.keySet());
    names.addAll(other.keySet());
    List<String> differences = new ArrayList<>();
    for (String name : names) {
      String value = identity.getOrDefault(name, missing(name));
      String found = other.getOrDefault(name, missing(name));
      if (!found.equals(value)) {
        differences.add(
            name + ": " + here + " has " + shown(value) + ", " + there + " has " + shown(found));
      }
    }
    if (!differences.isEmpty()) {
      throw new FilmMismatchException(String.join("; ", differences));
    }
  }
}
