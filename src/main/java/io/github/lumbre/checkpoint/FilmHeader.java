package io.github.lumbre.checkpoint;

import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.sampling.SobolSampler;
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
import java.util.Set;

/**
 * What a film is of.
 *
 * @param identity what samples depend on, texts by name: films that agree in all of it are of the
 *     same picture, and their samples may be added
 * @param hasAlpha whether the film counts the samples that cover each pixel
 * @param window the part of the full frame
 * @param parts which samples the film has, without overlaps; usually one
 * @param faults of its samples that count as black or are cut, and where the first are; nothing
 *     else
 * @param notes what else there is to know, texts by name, such as the scene's path
 */
public record FilmHeader(
    Map<String, String> identity,
    boolean hasAlpha,
    Crop window,
    List<FilmPart> parts,
    RenderStatistics faults,
    Map<String, String> notes) {
  /** Name in the identity: SHA-256 of the scene and of every file that it uses. */
  public static final String SCENE_HASH = "scene-hash";

  public static final String MODE = "mode";

  /** Name in the identity: one number for path tracing; mirrors and glass for ray tracing. */
  public static final String DEPTH = "depth";

  public static final String SEED = "seed";
  public static final String SIZE = "size";
  public static final String TRANSPARENT = "transparent";
  public static final String SAMPLER = "sampler";

  /** Name in the identity: {@link FilmRenderer#REVISION}. */
  public static final String REVISION = "revision";

  private static final String NOTHING = "nothing";

  /** Settings that every identity states in lines of their own form. */
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

  /** Returns what the samples of a scene, rendered by such settings, depend on. */
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
   * Returns the settings that stand in an identity under their own names, unless they have their
   * default.
   */
  public static List<Setting<?>> named() {
    return Setting.all().stream()
        .filter(setting -> setting.changesSamples() && !COMBINED.contains(setting))
        .toList();
  }

  /** Returns what a name stands for that an identity lacks. */
  private static String missing(String name) {
    return named().stream()
        .filter(setting -> setting.name().equals(name))
        .map(setting -> RenderSettings.DEFAULT.text(setting))
        .findAny()
        .orElse(NOTHING);
  }

  /** Returns a value for people, who do not read all digits of a hash. */
  private static String shown(String value) {
    return value.length() == 64 ? value.substring(0, 12) + "…" : value;
  }

  private static String depth(RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH -> String.valueOf(settings.maxTraceDepth());
      case RAY -> settings.reflectionTraceDepth() + "," + settings.refractionTraceDepth();
    };
  }

  /** Returns the header of a film of other parts. */
  FilmHeader withParts(Crop newWindow, List<FilmPart> newParts, RenderStatistics newFaults) {
    return new FilmHeader(identity, hasAlpha, newWindow, newParts, newFaults, notes);
  }

  /**
   * Passes if another identity is the same.
   *
   * @param here what this header belongs to, for the message
   * @param there what the other belongs to
   * @throws FilmMismatchException naming all that differs
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
