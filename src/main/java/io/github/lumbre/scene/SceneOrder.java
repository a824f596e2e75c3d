package io.github.lumbre.scene;

import io.github.lumbre.material.Material;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Transform;
import io.github.lumbre.scene.internal.Names;
import io.github.lumbre.scene.internal.SceneNode;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Adds what code described to a scene in the order of scene files: surfaces, models, lights,
 * background. Not reusable.
 */
final class SceneOrder {
  private final SceneAssembly scene;
  private final Placements placements;
  private final Map<Object, String> materialNames;
  private final Names names = new Names("object");
  private final List<Runnable> models = new ArrayList<>();
  private final List<Runnable> lights = new ArrayList<>();
  private final List<Runnable> backgrounds = new ArrayList<>();

  SceneOrder(SceneAssembly scene, Placements placements, Map<Material, String> materialNames) {
    this.scene = scene;
    this.placements = placements;
    this.materialNames = new IdentityHashMap<>(materialNames);
  }

  void add(List<SceneNode> nodes) {
    addAll(nodes, Transform.IDENTITY, true);
    models.forEach(Runnable::run);
    lights.forEach(Runnable::run);
    backgrounds.forEach(Runnable::run);
  }

  private void addAll(List<SceneNode> nodes, Transform outer, boolean isOutermost) {
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Group group) {
        addAll(
            group.children(),
            isOutermost ? group.transform() : outer.times(group.transform()),
            false);
      } else if (node instanceof SceneNode.Surface surface) {
        addSurface(surface, outer, isOutermost);
      } else if (node instanceof SceneNode.Part part) {
        Transform toWorld = isOutermost ? part.transform() : outer.times(part.transform());
        models.add(() -> addPart(part, toWorld));
      } else if (node instanceof SceneNode.Lamp lamp) {
        lights.add(() -> addLamp(lamp, outer, isOutermost));
      } else if (node instanceof SceneNode.Ambient ambient) {
        lights.add(() -> scene.addAmbient(ambient.irradiance()));
      } else if (node instanceof SceneNode.Background background) {
        backgrounds.add(() -> addBackground(background));
      }
    }
  }

  private void addSurface(SceneNode.Surface surface, Transform outer, boolean isOutermost) {
    scene.lightGroup(surface.lightGroup());
    scene.named(objectName(surface), materialName(surface));
    var shape = placements.shape(surface, outer, isOutermost);
    if (surface.emission().isEmpty()) {
      scene.add(shape, surface.material());
    } else if (surface.isDeclared()) {
      scene.addAreaLight(shape, surface.emission().get());
    } else {
      scene.add(shape, surface.material(), surface.emission().get());
    }
  }

  private String objectName(SceneNode.Surface surface) {
    return names.unused(
        surface.name().isEmpty() ? "object " + scene.primitiveCount() : surface.name());
  }

  /** Returns the name of a material; a material without one is named by its first surface. */
  private String materialName(SceneNode.Surface surface) {
    Object material =
        surface.material() == Unlit.INSTANCE && surface.emission().isPresent()
            ? surface.emission().get()
            : surface.material();
    return materialNames.computeIfAbsent(material, key -> "material " + scene.primitiveCount());
  }

  private void addPart(SceneNode.Part part, Transform toWorld) {
    scene.lightGroup(part.lightGroup());
    placements.content(part, toWorld).addTo(scene);
  }

  private void addLamp(SceneNode.Lamp lamp, Transform outer, boolean isOutermost) {
    scene.lightGroup(lamp.lightGroup());
    scene.add(isOutermost ? lamp.light() : lamp.light().transformed(outer));
  }

  private void addBackground(SceneNode.Background background) {
    scene.lightGroup(background.lightGroup());
    scene.addBackground(background.radiance());
  }
}
