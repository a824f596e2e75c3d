package io.github.lumbre.render;

import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.SceneInside;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.Set;

/**
 * The layers of a film.
 *
 * @param kinds the layers that can be developed, in the order of their declaration
 * @param lightGroups the number of light groups, 0 or more
 */
public record FilmLayers(Set<Layer> kinds, int lightGroups) {
  /** No layers. */
  public static final FilmLayers NONE = new FilmLayers(Set.of(), 0);

  public FilmLayers {
    EnumSet<Layer> sorted = EnumSet.noneOf(Layer.class);
    sorted.addAll(kinds);
    kinds = Collections.unmodifiableSet(sorted);
    if (lightGroups < 0) {
      throw new IllegalArgumentException("lightGroups: expected at least 0, found " + lightGroups);
    }
  }

  /** Returns the layers that a render with the given settings records. */
  public static FilmLayers of(RenderSettings settings, Scene scene) {
    boolean hasLights = settings.layers().contains(Layer.LIGHTS);
    Set<Layer> kinds = new HashSet<>(settings.layers());
    if (!scene.catchesShadows()) {
      kinds.remove(Layer.DENOISING_ALPHA);
    }
    return new FilmLayers(
        kinds, hasLights ? SceneInside.of(scene).lightGroups().names().size() : 0);
  }

  /** Returns whether there are no layers. */
  public boolean isEmpty() {
    return kinds.isEmpty();
  }

  /** Returns the layers whose values the film sums, in the order of their declaration. */
  Set<Layer> stored() {
    EnumSet<Layer> stored = EnumSet.noneOf(Layer.class);
    for (Layer layer : kinds) {
      if (layer == Layer.INDIRECT) {
        stored.add(Layer.DIRECT);
      } else if (LayerGrid.of(layer) != LayerGrid.NONE && LayerGrid.of(layer) != LayerGrid.COUNTS) {
        stored.add(layer);
      }
    }
    return stored;
  }

  /** Returns the number of sums of a stored layer. */
  int channels(Layer layer) {
    return layer == Layer.LIGHTS ? 3 * lightGroups : layer.channels().size();
  }

  /** Returns whether a film counts the samples of each primitive. */
  public boolean countsPrimitives() {
    return kinds.contains(Layer.OBJECT) || kinds.contains(Layer.MATERIAL);
  }

  /** Returns whether a film counts the samples that hit a surface. */
  boolean countsHits() {
    return kinds.stream().anyMatch(FilmLayers::isOfHits);
  }

  /** Returns whether a layer is a mean over the samples that hit a surface. */
  static boolean isOfHits(Layer layer) {
    return switch (layer) {
      case POSITION, DEPTH, UV -> true;
      default -> false;
    };
  }

  /**
   * Returns the bytes that the layers take per pixel. Pixels with more than one primitive take
   * about 16 bytes more for each.
   */
  public int bytesPerPixel() {
    int bytes = countsHits() ? Integer.BYTES : 0;
    bytes += countsPrimitives() ? PrimitiveCounts.BYTES_PER_PIXEL : 0;
    for (Layer layer : stored()) {
      bytes += LayerGrid.of(layer).bytes() * channels(layer);
      bytes += LayerGrid.of(layer) == LayerGrid.GUIDE ? Long.BYTES : 0;
    }
    return bytes;
  }
}
