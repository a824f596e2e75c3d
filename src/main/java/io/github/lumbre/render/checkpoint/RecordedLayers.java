package io.github.lumbre.render.checkpoint;

import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.SurfaceNames;
import java.util.List;
import java.util.Set;

/**
 * The layers of a film in a file, with the names that the scene gives to their contents.
 *
 * @param kinds the layers
 * @param lightGroups the names of the light groups; empty without {@link Layer#LIGHTS}
 * @param objects the name of the object of each of the scene's primitives; empty without {@link
 *     Layer#OBJECT} and {@link Layer#MATERIAL}, and for scenes whose names are too long for a
 *     file's header
 * @param materials the name of the material of each primitive, as many
 */
public record RecordedLayers(
    Set<Layer> kinds, List<String> lightGroups, List<String> objects, List<String> materials) {
  /** The largest number of light groups of a film. */
  public static final int MAX_LIGHT_GROUPS = 256;

  /** The largest number of characters of all names of primitives. */
  private static final long MAX_NAME_LENGTH = 1 << 22;

  /** No layers. */
  public static final RecordedLayers NONE =
      new RecordedLayers(Set.of(), List.of(), List.of(), List.of());

  public RecordedLayers {
    kinds = Layer.setOf(kinds.toArray(Layer[]::new));
    lightGroups = List.copyOf(lightGroups);
    SurfaceNames names = new SurfaceNames(objects, materials);
    objects = names.objects();
    materials = names.materials();
    if (lightGroups.size() > MAX_LIGHT_GROUPS) {
      throw new IllegalArgumentException(
          "light groups: expected at most " + MAX_LIGHT_GROUPS + ", found " + lightGroups.size());
    }
  }

  /** Returns the layers that a render of a scene records. */
  public static RecordedLayers of(RenderSettings settings, Scene scene) {
    FilmLayers layers = FilmLayers.of(settings, scene);
    SceneInside inside = SceneInside.of(scene);
    SurfaceNames all = inside.names();
    SurfaceNames names =
        layers.countsPrimitives() && all.length() <= MAX_NAME_LENGTH ? all : SurfaceNames.NONE;
    return new RecordedLayers(
        layers.kinds(),
        layers.lightGroups() == 0 ? List.of() : inside.lightGroups().names(),
        names.objects(),
        names.materials());
  }

  /** Returns the layers of the film itself. */
  public FilmLayers ofFilm() {
    return new FilmLayers(kinds, lightGroups.size());
  }

  /** Returns whether there are no layers. */
  public boolean isEmpty() {
    return kinds.isEmpty();
  }
}
