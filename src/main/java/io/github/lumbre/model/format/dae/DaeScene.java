package io.github.lumbre.model.format.dae;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.dae.DaeMaterials.Look;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelReach;
import io.github.lumbre.model.internal.PlainModel;
import java.io.IOException;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Walks the nodes of the scene. Surfaces are collected first and made afterwards, since the
 * materials of all decide what is transparent. Mutable.
 */
final class DaeScene {
  /** A surface and where it is. */
  private record Placed(
      ModelNode node, DaeGeometry.Group group, Optional<Look> look, Transform toWorld) {}

  private final DaeDocument document;
  private final FormatFile file;
  private final DaeTransforms transforms;
  private final DaeMaterials materials;
  private final DaeCameras cameraReader;
  private final DaeNodes nodes;
  private final Transform toWorld;
  private final List<Placed> placed = new ArrayList<>();
  private final List<ModelCamera> cameras = new ArrayList<>();
  private final Map<ModelGeometry, Bounds3> bounds = new IdentityHashMap<>();
  private Optional<DaeSkins> skins = Optional.empty();

  /**
   * @param toWorld from the axes and the unit of the file
   * @param unit the length of the file's unit
   */
  DaeScene(DaeDocument document, Transform toWorld, double unit) {
    this.document = document;
    this.toWorld = toWorld;
    file = document.file();
    transforms = new DaeTransforms(document);
    materials = new DaeMaterials(document);
    cameraReader = new DaeCameras(document, unit);
    nodes = new DaeNodes(document);
  }

  List<ModelCamera> cameras() {
    return cameras;
  }

  /** Returns the parts of the scene. */
  List<ModelPart> parts() throws ModelFormatException, IOException {
    DaeElement scene = scene();
    skins = Optional.of(new DaeSkins(document, nodes.places(scene, transforms)));
    ModelLimits.require(scene.location(), "parts", ModelLimits.MAX_PARTS, nodes.surfaces(scene));
    for (DaeElement node : scene.children("node")) {
      walk(node, Transform.IDENTITY, Optional.empty());
    }
    List<Look> looks = placed.stream().flatMap(surface -> surface.look.stream()).toList();
    if (!looks.isEmpty() && looks.stream().allMatch(materials::isInvisible)) {
      materials.showOpaque();
    }
    List<ModelPart> parts = new ArrayList<>();
    for (Placed each : placed) {
      part(each).ifPresent(parts::add);
    }
    return parts;
  }

  /**
   * Returns the scene that the file shows; the first one, or one of all geometries, with a warning,
   * if it states none.
   */
  private DaeElement scene() {
    Optional<DaeElement> instance = document.root().find("scene", "instance_visual_scene");
    Optional<DaeElement> stated =
        instance.flatMap(i -> document.find("visual_scene", i.attribute("url"), i.location()));
    if (stated.isPresent()) {
      return stated.get();
    }
    List<DaeElement> scenes = document.library("library_visual_scenes", "visual_scene");
    boolean hasScenes = !scenes.isEmpty();
    file.warnings()
        .add(
            "",
            "expected a <scene> with an <instance_visual_scene>, found none; %s"
                .formatted(
                    hasScenes
                        ? "the first scene of the file is shown"
                        : "all geometries of the file are shown"));
    return hasScenes ? scenes.get(0) : DaeNodes.sceneOfGeometries(document);
  }

  private void walk(DaeElement node, Transform parent, Optional<ModelNode> above)
      throws ModelFormatException {
    Transform here = parent.times(transforms.of(node));
    if (!here.isInvertible()) {
      file.warnings()
          .add(
              "transforms that are not invertible",
              node.location(),
              "its transform is not invertible; its content is left out");
      return;
    }
    ModelNode part = ModelNode.of(node.title(), "node", above);
    for (DaeElement child : node.children()) {
      switch (child.name()) {
        case "node" -> {
          if (nodes.isShown(child)) {
            walk(child, here, Optional.of(part));
          }
        }
        case "instance_node" -> {
          Optional<DaeElement> target = nodes.target(child);
          if (target.isPresent()) {
            walk(target.get(), here, Optional.of(part));
          }
        }
        case "instance_geometry" ->
            place(nodes.geometry(child), child, part, toWorld.times(here));
        case "instance_controller" -> placeSkin(child, part, here);
        case "instance_camera" ->
            cameraReader.camera(child, node, toWorld.times(here)).ifPresent(cameras::add);
        case "instance_light" ->
            file.warnings().once(" lights", child.location(), "lights are left out");
        default -> {
          // Transforms, and what has no effect.
        }
      }
    }
  }

  private void placeSkin(DaeElement instance, ModelNode part, Transform here)
      throws ModelFormatException {
    Optional<DaeSkins.Bound> bound = skins.orElseThrow().bound(instance);
    if (bound.isPresent()) {
      Transform place = bound.get().inScene().filter(Transform::isInvertible).orElse(here);
      place(nodes.geometry(bound.get().geometry()), instance, part, toWorld.times(place));
    }
  }

  private void place(
      List<DaeGeometry.Group> groups, DaeElement instance, ModelNode node, Transform place)
      throws ModelFormatException {
    ModelLimits.require(
        instance.location(), "parts", ModelLimits.MAX_PARTS, placed.size() + groups.size());
    Map<String, DaeElement> bound = DaeMaterials.bound(instance);
    for (DaeGeometry.Group group : groups) {
      placed.add(new Placed(node, group, materials.look(instance, bound, group.symbol()), place));
    }
  }

  private Optional<ModelPart> part(Placed surface) throws ModelFormatException, IOException {
    DaeGeometry.Group group = surface.group;
    List<Integer> used = List.of();
    if (surface.look.isPresent()) {
      used = materials.sets(surface.look.get(), group.sets());
    }
    ModelGeometry geometry = group.geometry(used);
    if (geometry.triangleCount() == 0 || isBeyond(surface, geometry)) {
      return Optional.empty();
    }
    ModelMaterial material = PlainModel.material(geometry.colors());
    if (surface.look.isPresent()) {
      boolean hasAlpha = material.alphaMode() != AlphaMode.OPAQUE;
      material = materials.material(surface.look.get(), used, group.sets(), group.isOneSided());
      if (hasAlpha && material.alphaMode() == AlphaMode.OPAQUE) {
        file.warnings()
            .add(group.location(), "ignored alpha of vertices, whose material is opaque");
      }
    }
    return Optional.of(
        new ModelPart(surface.node, group.location(), geometry, material, surface.toWorld));
  }

  private boolean isBeyond(Placed surface, ModelGeometry geometry) {
    Bounds3 box =
        surface.toWorld.bounds(bounds.computeIfAbsent(geometry, ModelGeometry::bounds));
    boolean isWithin =
        surface.toWorld.isInvertible()
            && Math.max(box.min().maxAbs(), box.max().maxAbs()) <= ModelReach.LARGEST;
    if (!isWithin) {
      file.warnings()
          .add(
              "parts beyond 1e100",
              surface.group.location(),
              "expected a part within 1e100 of the origin, found one beyond, which is left out");
    }
    return !isWithin;
  }
}
