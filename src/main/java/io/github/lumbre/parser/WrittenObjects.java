package io.github.lumbre.parser;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.camera.internal.BokehCache;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFile;
import io.github.lumbre.scene.internal.SceneNode;
import io.github.lumbre.scene.internal.SurfaceNames;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Writes the tree of objects. Not reusable: it counts the surfaces. */
final class WrittenObjects {
  private final WrittenAssets assets;
  private final WrittenTextures textures;
  private final WrittenMaterials materials;
  private final SurfaceNames names;
  private int surfaces;

  /**
   * @param names of the objects and materials; surfaces come first and in the order of the nodes
   */
  WrittenObjects(WrittenAssets assets, SurfaceNames names) {
    this.assets = assets;
    this.names = names;
    textures = new WrittenTextures(assets);
    materials = new WrittenMaterials(assets, textures);
  }

  /** Returns the objects of nodes; backgrounds are none. */
  JsonArray all(List<SceneNode> nodes) {
    JsonArray all = new JsonArray();
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Group group) {
        all.add(group(group));
      } else if (node instanceof SceneNode.Surface surface) {
        all.add(surface(surface));
      } else if (node instanceof SceneNode.Lamp lamp) {
        all.add(new WrittenLights(textures).light(lamp));
      } else if (node instanceof SceneNode.Ambient ambient) {
        all.add(WrittenLights.ambient(ambient.irradiance()));
      } else if (node instanceof SceneNode.Part part) {
        all.add(part(part));
      }
    }
    return all;
  }

  private JsonObject group(SceneNode.Group group) {
    JsonObject object = object("None", group.name());
    place(object, group.transform());
    object.add("children", all(group.children()));
    return object;
  }

  static JsonObject object(String type, String name) {
    JsonObject object = new JsonObject();
    object.addProperty("type", type);
    if (!name.isEmpty()) {
      object.addProperty("name", name);
    }
    return object;
  }

  /** Writes a transform: a position if that has the same bits, otherwise a matrix. */
  static void place(JsonObject object, Transform transform) {
    Vec3 position = transform.point(Vec3.ZERO);
    Transform moved =
        Transform.translation(position)
            .times(Transform.rotationDegrees(Vec3.ZERO))
            .times(Transform.scale(new Vec3(1, 1, 1)));
    double[] values = transform.toArray();
    if (Arrays.equals(values, moved.toArray())
        && Arrays.equals(values, Transform.IDENTITY.times(moved).toArray())) {
      object.add("localPosition", Written.vector(position));
    } else {
      matrix(object, transform);
    }
  }

  /** Writes a transform as a matrix. */
  static void matrix(JsonObject object, Transform transform) {
    JsonArray numbers = new JsonArray();
    Arrays.stream(LocalTransform.numbers(transform)).forEach(numbers::add);
    object.add("matrix", numbers);
  }

  private JsonObject surface(SceneNode.Surface surface) {
    String name = names.object(surfaces);
    String materialName = names.material(surfaces);
    surfaces++;
    try {
      JsonObject object = object("Shape", name);
      if (!surface.lightGroup().isEmpty()) {
        object.addProperty("lightGroup", surface.lightGroup());
      }
      object.addProperty("materialID", materials.id(surface, materialName));
      shape(object, surface.shape());
      return object;
    } catch (Unwritable e) {
      throw e.at("\"" + name + '"');
    }
  }

  private void shape(JsonObject to, Shape shape) {
    if (shape instanceof Sphere sphere) {
      to.addProperty("shapeType", "Sphere");
      to.addProperty("radius", sphere.radius());
      place(to, sphere.toWorld());
    } else if (shape instanceof Plane plane) {
      to.addProperty("shapeType", "Plane");
      to.addProperty("twoSided", plane.isTwoSided());
      place(to, plane.toWorld());
    } else if (shape instanceof Rectangle rectangle) {
      to.addProperty("shapeType", "Plane");
      to.addProperty("finite", true);
      to.addProperty("width", rectangle.width());
      to.addProperty("height", rectangle.height());
      to.addProperty("twoSided", rectangle.isTwoSided());
      place(to, rectangle.toWorld());
    } else if (shape instanceof Box box) {
      to.addProperty("shapeType", "Cube");
      to.addProperty("width", box.size().x());
      to.addProperty("height", box.size().y());
      to.addProperty("depth", box.size().z());
      place(to, box.toWorld());
    } else if (shape instanceof MeshInstance instance) {
      mesh(to, instance.shared(), "", instance.shared().mesh(), instance.toWorld());
      to.addProperty("shared", true);
    } else if (shape instanceof Mesh mesh) {
      Mesh.Source source =
          mesh.source().orElseThrow(() -> new Unwritable("a mesh of Mesh.of", "one of Mesh.baked"));
      // An asset for each: readers would share one that two shapes use.
      mesh(to, mesh, "" + surfaces, source.mesh(), source.toWorld());
    } else {
      throw new Unwritable("a shape that scenes have", "one of Sphere.cloud");
    }
  }

  private void mesh(
      JsonObject to, Object key, String variant, TriangleMesh mesh, Transform toWorld) {
    to.addProperty("shapeType", "Mesh");
    to.addProperty(
        "meshId",
        assets.id(
            key,
            variant,
            "Mesh",
            asset -> asset.addProperty("file", assets.file("mesh", ObjText.of(mesh), "obj"))));
    place(to, toWorld);
  }

  private JsonObject part(SceneNode.Part part) {
    if (!(part.content() instanceof ModelFile model)) {
      throw new Unwritable("a model of Models.read", Written.name(part.content()));
    }
    JsonObject object = object("Model", part.name());
    place(object, part.transform());
    if (!part.lightGroup().isEmpty()) {
      object.addProperty("lightGroup", part.lightGroup());
    }
    object.addProperty("file", file(model));
    Written.options(object, model.options());
    object.addProperty("useLights", model.usesLights());
    object.addProperty("shared", model.isMovable());
    return object;
  }

  /** Adds a model with the files that it names, in a folder of its own. */
  private String file(ModelFile model) {
    byte[] content = model.content();
    StringBuilder all = new StringBuilder(Sha256.of(content));
    Map<String, byte[]> others = model.files();
    others.forEach((name, bytes) -> all.append(name).append(Sha256.of(bytes)));
    byte[] key = all.toString().getBytes(StandardCharsets.UTF_8);
    String folder = WrittenAssets.FOLDER + "model-" + WrittenAssets.shortHash(key) + "/";
    assets.file(folder + model.name(), content);
    others.forEach((name, bytes) -> assets.file(folder + name, bytes));
    return folder + model.name();
  }

  JsonObject camera(Viewpoint from) {
    JsonObject object = object("Camera", "");
    object.addProperty("id", 1);
    object.add("localPosition", Written.vector(from.eye()));
    object.add("lookAt", Written.vector(from.target()));
    object.add("lookAtUp", Written.vector(from.up()));
    lens(object, from.lens());
    return object;
  }

  private void lens(JsonObject to, Lens lens) {
    if (lens instanceof Lens.Pinhole pinhole) {
      to.addProperty("cameraType", "Pinhole");
      to.addProperty("fieldOfView", pinhole.fovDegrees());
    } else if (lens instanceof Lens.ThinLens thin) {
      to.addProperty("cameraType", "ThinLens");
      to.addProperty("fieldOfView", thin.fovDegrees());
      to.addProperty("focusDistance", Math.min(thin.focusDistance(), Double.MAX_VALUE));
      to.addProperty("aperture", thin.apertureSize());
      mask(thin.aperture())
          .ifPresent(mask -> to.addProperty("bokehTextureId", textures.mask(mask)));
    } else if (lens instanceof Lens.Orthographic parallel) {
      to.addProperty("cameraType", "Orthographic");
      to.addProperty("height", parallel.height());
    } else if (lens instanceof Lens.Cylindrical cylinder) {
      to.addProperty("cameraType", "Cylindrical");
      to.addProperty("height", cylinder.halfHeight());
    } else if (lens instanceof Lens.Spherical) {
      to.addProperty("cameraType", "Spherical");
    } else if (lens instanceof Lens.FishEye fishEye) {
      to.addProperty("cameraType", "FishEye");
      to.addProperty("angle", fishEye.angleDegrees());
    }
  }

  private static Optional<BokehCache> mask(Aperture aperture) {
    if (aperture instanceof BokehCache mask) {
      return Optional.of(mask);
    }
    if (aperture == Aperture.DISK) {
      return Optional.empty();
    }
    throw new Unwritable("aperture: a disk or a mask", Written.name(aperture));
  }
}
