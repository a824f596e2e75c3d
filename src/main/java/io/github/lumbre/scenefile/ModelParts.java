package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.model.internal.ModelSurface;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.PartSurface;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Adds models to the parts of a scene, and counts what the models have. */
final class ModelParts {
  private final PlacedParts parts;
  private final Allowance allowance;
  private final Kernel kernel;
  private final DecodedPictures decoded;
  private final Set<ModelGeometry> meshes = identitySet();
  private final Set<ModelMaterial> ownMaterials = identitySet();
  private final Map<Integer, PartSurface> surfaces = new HashMap<>();
  private List<PlacedCamera> cameras = List.of();
  private int count;
  private int pictures;
  private int lights;
  private long triangles;
  private long points;

  /**
   * @param kernel traversal kernel of shared meshes
   * @param decoded the pictures of models that were read before
   */
  ModelParts(PlacedParts parts, Allowance allowance, Kernel kernel, DecodedPictures decoded) {
    this.parts = parts;
    this.allowance = allowance;
    this.kernel = kernel;
    this.decoded = decoded;
  }

  private static <T> Set<T> identitySet() {
    return Collections.newSetFromMap(new IdentityHashMap<>());
  }

  /**
   * How a model stands in a scene.
   *
   * @param toWorld from the left-handed space of the model
   * @param isShared whether all meshes have hierarchies in their local space
   * @param overrides surfaces that replace materials of the model, by their names
   * @param lightGroup of the model's lights; empty for none
   */
  record Placement(
      ModelPlace place,
      Transform toWorld,
      boolean isShared,
      Map<String, Surface> overrides,
      boolean useLights,
      String lightGroup) {  }

  /** Sets the camera of a model, in each pose, as the camera of the scene. */
  void seenBy(List<PlacedCamera> camera) {
    cameras = camera;
  }

  /** Returns the camera of a model that is the scene's, in each pose; empty if there is none. */
  List<PlacedCamera> cameras() {
    return cameras;
  }

  /** Returns the number of surfaces added so far. */
  int count() {
    return count;
  }

  /** Returns the number of meshes added so far; instances share one. */
  int meshes() {
    return meshes.size();
  }

  /** Returns the number of materials of the models in use, without default materials. */
  int materials() {
    return ownMaterials.size();
  }

  /** Returns the number of pictures that the models' materials use. */
  int pictures() {
    return pictures;
  }

  /** Returns the number of the models' lights in use. */
  int lights() {
    return lights;
  }

  /** Returns the number of triangles added so far, counted for each instance. */
  long triangles() {
    return triangles;
  }

  /** Returns the number of points added so far, counted for each instance. */
  long points() {
    return points;
  }

  /**
   * Returns the surfaces in the scene, by the numbers of their primitives, once the scene is made.
   */
  Map<Integer, PartSurface> surfaces() {
    return surfaces;
  }

  /** Adds a model, and its warnings and its error to the problems. */
  void add(Model model, Placement placement) {
    ModelPlace place = placement.place;
    model.warnings().forEach(place::warn);
    Transform toWorld = placement.toWorld.times(ModelScene.TO_LEFT_HANDED);
    ModelScene scene =
        new ModelScene(model, toWorld, kernel, allowance.left(), placement.isShared, decoded);
    try {
      if (model.poses().isEmpty()) {
        add(scene, placement, parts, true);
      } else {
        addPoses(model, scene, placement);
      }
    } catch (ModelFormatException e) {
      place.error(e);
      return;
    }
    scene.warnings().forEach(place::warn);
    allowance.addTexels(scene.texels());
    pictures += scene.pictures();
  }

  private void addPoses(Model model, ModelScene scene, Placement placement)
      throws ModelFormatException {
    List<PlacedParts> all = new ArrayList<>();
    for (Model pose : model.poses()) {
      PlacedParts own = new PlacedParts();
      boolean isMiddle = all.size() == model.poses().size() / 2;
      add(scene.posed(pose), placement, own, isMiddle);
      all.add(own);
    }
    parts.addPoses(all);
  }

  /**
   * Adds a model in a pose.
   *
   * @param isCounted whether its surfaces and lights are counted; others are other poses of them
   */
  private void add(ModelScene scene, Placement placement, PlacedParts target, boolean isCounted)
      throws ModelFormatException {
    for (ModelSurface surface : scene.surfaces()) {
      if (isCounted) {
        count(surface.part(), placement);
      }
      add(surface, placement, target, isCounted);
    }
    if (placement.useLights) {
      for (Light light : scene.lights()) {
        lights += isCounted ? 1 : 0;
        Origin origin = placement.place.origin("lights", "");
        target.add(origin, Origin.NONE, placement.lightGroup, b -> b.add(light));
      }
    }
  }

  private void count(ModelPart part, Placement placement) {
    count++;
    allowance.addTriangles(part.geometry().itemCount());
    if (part.geometry().isPoints()) {
      points += part.geometry().itemCount();
    } else {
      triangles += part.geometry().triangleCount();
      meshes.add(part.geometry());
    }
    ModelMaterial material = part.material();
    boolean isReplaced = placement.overrides.containsKey(material.name());
    if (!isReplaced && !material.location().isEmpty()) {
      ownMaterials.add(material);
    }
  }

  private void add(
      ModelSurface surface, Placement placement, PlacedParts target, boolean isCounted) {
    ModelPart part = surface.part();
    ModelMaterial material = part.material();
    Optional<Surface> other = Optional.ofNullable(placement.overrides.get(material.name()));
    PartSurface shown = PartSurface.of(part);
    if (ShapeReader.isMeasurable(placement.place.problemPlace(), surface.shape().bounds())) {
      target.add(
          placement.place.origin(part.location(), part.name()),
          placement.place.origin(material.location(), material.name()),
          placement.lightGroup,
          scene -> {
            int first = scene.primitiveCount();
            other.ifPresentOrElse(
                own -> own.add(surface.shape(), scene), () -> surface.addTo(scene));
            int end = isCounted ? scene.primitiveCount() : first;
            for (int primitive = first; primitive < end; primitive++) {
              surfaces.put(primitive, shown);
            }
          });
    }
  }
}
