package io.github.lumbre.scene;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.scene.internal.LightGroups;
import io.github.lumbre.scene.internal.SceneDescription;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The surfaces and lights of a scene in world space, in their order: what readers of files and
 * {@link SceneBuilder} make. Mutable; the scene is immutable.
 */
public final class SceneAssembly {
  final Camera camera;
  final List<Primitive> primitives = new ArrayList<>();
  final List<Light> lights = new ArrayList<>();
  final List<Light> emitters = new ArrayList<>();
  final Map<Integer, Integer> emitterOfPrimitive = new HashMap<>();
  final List<String> objectNames = new ArrayList<>();
  final List<String> materialNames = new ArrayList<>();
  final List<String> groupOfPrimitive = new ArrayList<>();
  final List<String> groupOfEmitter = new ArrayList<>();
  Rgb ambient = Rgb.BLACK;
  Optional<Backplate> backplate = Optional.empty();
  Kernel kernel = Kernel.AUTO;
  boolean isSearchedLater;
  private String objectName = "";
  private String materialName = "";
  private String lightGroup = "";

  /** Creates an empty scene with a camera. */
  public SceneAssembly(Camera camera) {
    this.camera = Objects.requireNonNull(camera, "camera");
  }

  /**
   * Names the surfaces that are added next. Surfaces with the same name form one matte.
   *
   * @param object name of the object; empty for a name by the number of the surface
   * @param material name of the material; empty for a name by the number of the surface
   */
  public SceneAssembly named(String object, String material) {
    objectName = Objects.requireNonNull(object, "object");
    materialName = Objects.requireNonNull(material, "material");
    return this;
  }

  /**
   * Puts the lights that are added next into a light group; see {@link Layer#LIGHTS}.
   *
   * @param name letters, digits and underscores; empty for no group
   * @throws IllegalArgumentException if the name has other characters
   */
  public SceneAssembly lightGroup(String name) {
    LightGroups.require(name);
    lightGroup = name;
    return this;
  }

  /** Adds a surface that scatters light and does not emit any. */
  public SceneAssembly add(Shape shape, Material material) {
    add(new Primitive(shape, material, Optional.empty()));
    return this;
  }

  private void add(Primitive primitive) {
    primitives.add(primitive);
    objectNames.add(objectName);
    materialNames.add(materialName);
    groupOfPrimitive.add(lightGroup);
  }

  private void addEmitter(Light light) {
    emitters.add(light);
    groupOfEmitter.add(lightGroup);
  }

  /**
   * Adds a light without a surface, such as a point light or an environment light. Black lights are
   * ignored.
   */
  public SceneAssembly add(Light light) {
    if (!light.isBlack()) {
      lights.add(light);
      addEmitter(light);
    }
    return this;
  }

  /**
   * Adds an area light: a surface that emits light, does not scatter any, and is sampled as a light
   * in both modes. An infinite plane cannot be sampled; it contributes only to paths that hit it.
   */
  public SceneAssembly addAreaLight(Shape shape, Emission emission) {
    AreaLight light = new AreaLight(shape, emission);
    add(light, Unlit.INSTANCE);
    if (!light.isBlack() && Double.isFinite(shape.area())) {
      lights.add(light);
    }
    return this;
  }

  /**
   * Adds a surface that emits light. In path mode, it is also sampled as a light; an infinite plane
   * cannot be.
   *
   * @param material how the surface scatters light; {@link Unlit} if it does not
   */
  public SceneAssembly add(Shape shape, Material material, Emission emission) {
    return add(new AreaLight(shape, emission), material);
  }

  /**
   * Adds a surface that shows a color to all rays that hit it, and is not sampled as a light.
   *
   * @param material how the surface scatters light, or lets it through
   */
  public SceneAssembly addFlat(Shape shape, Material material, Emission emission) {
    add(new Primitive(shape, material, Optional.of(emission)));
    return this;
  }

  private SceneAssembly add(AreaLight light, Material material) {
    if (!light.emission().isBlack() && Double.isFinite(light.shape().area())) {
      emitterOfPrimitive.put(primitives.size(), emitters.size());
      addEmitter(light);
    }
    add(new Primitive(light.shape(), material, Optional.of(light.emission())));
    return this;
  }

  /** Adds a uniform environment light, which lights surfaces in path mode. */
  public SceneAssembly addBackground(Rgb radiance) {
    if (!radiance.isBlack()) {
      addEmitter(EnvironmentLight.uniform(radiance));
    }
    return this;
  }

  /**
   * Adds ambient irradiance, which every diffuse surface receives uniformly from all directions.
   */
  public SceneAssembly addAmbient(Rgb irradiance) {
    ambient = ambient.plus(irradiance);
    return this;
  }

  /** Sets what the camera sees instead of environment lights, which still give light. */
  public SceneAssembly backplate(Backplate seen) {
    backplate = Optional.of(seen);
    return this;
  }

  /**
   * Sets the traversal kernel; the default is {@link Kernel#AUTO}. Renders of all kernels are
   * bit-identical.
   */
  public SceneAssembly searchedBy(Kernel newKernel) {
    kernel = Objects.requireNonNull(newKernel, "kernel");
    return this;
  }

  /** Delays building the hierarchy of a scene that does not move until the first ray is traced. */
  public SceneAssembly searchedLater() {
    isSearchedLater = true;
    return this;
  }

  /** Returns the current number of primitives. */
  public int primitiveCount() {
    return primitives.size();
  }

  /** Returns the current number of emitters. */
  public int emitterCount() {
    return emitters.size();
  }

  /**
   * Returns the scene.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public Scene build() {
    return new Scene(this, Optional.empty());
  }

  /**
   * Returns a scene in motion, whose poses share the hierarchies of what does not move; see {@link
   * Scene#inMotion}.
   *
   * @param poses in the order of time; a shape that does not move is the same object in all of
   *     them. A single pose stands still
   * @throws IllegalStateException if the kernel is not available
   */
  public static Scene inMotion(List<SceneAssembly> poses) {
    if (poses.size() == 1) {
      return poses.get(0).build();
    }
    List<Hierarchies> hierarchies = Hierarchies.inMotion(poses);
    List<Scene> scenes = new ArrayList<>();
    for (int i = 0; i < poses.size(); i++) {
      SceneAssembly pose = poses.get(i);
      scenes.add(
          i > 0 && pose.isSame(poses.get(i - 1))
              ? scenes.get(i - 1)
              : new Scene(pose, Optional.empty(), Optional.of(hierarchies.get(i))));
    }
    return Scene.inMotion(scenes);
  }

  private boolean isSame(SceneAssembly other) {
    return camera == other.camera
        && primitives.equals(other.primitives)
        && lights.equals(other.lights)
        && emitters.equals(other.emitters);
  }

  List<Shape> shapes() {
    return primitives.stream().map(Primitive::shape).toList();
  }

  List<Light> allLights() {
    return Stream.concat(lights.stream(), emitters.stream()).toList();
  }

  /**
   * Returns the scene with what it was built from.
   *
   * @param origin a scene whose hierarchy is used if it has the same shapes
   */
  Scene build(SceneDescription description, Placements placements, Optional<Scene> origin) {
    return new Scene(this, Optional.of(new Scene.Built(description, placements, origin)));
  }
}
