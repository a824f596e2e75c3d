package io.github.lumbre.scene;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.LightGroups;
import io.github.lumbre.scene.internal.Names;
import io.github.lumbre.scene.internal.SceneDescription;
import io.github.lumbre.scene.internal.SceneNode;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Builds a {@link Scene} in code. Mutable; the scene is immutable.
 *
 * <p>The scene's surfaces come first, then {@linkplain SceneContent models}, then lights, each in
 * the order in which they were added, as in a scene file.
 */
public final class SceneBuilder {
  private final boolean isGroup;
  private final List<SceneNode> nodes = new ArrayList<>();
  private final Map<Material, String> materialNames;
  private Optional<Camera> camera = Optional.empty();
  private Optional<Viewpoint> viewpoint = Optional.empty();
  private Optional<Backplate> backplate = Optional.empty();
  private Optional<Scene> origin = Optional.empty();
  private String lightGroup = "";

  SceneBuilder() {
    isGroup = false;
    materialNames = new IdentityHashMap<>();
  }

  private SceneBuilder(SceneBuilder parent) {
    isGroup = true;
    materialNames = parent.materialNames;
    lightGroup = parent.lightGroup;
  }

  /** Continues a scene that was built in code. */
  SceneBuilder(Scene origin, SceneDescription description) {
    isGroup = false;
    materialNames = new IdentityHashMap<>(description.materialNames());
    nodes.addAll(description.nodes());
    viewpoint = description.viewpoint();
    camera = viewpoint.isPresent() ? Optional.empty() : Optional.of(origin.camera());
    backplate = description.backplate();
    this.origin = Optional.of(origin);
  }

  /**
   * Sets where the camera stands and looks. The settings of a render give the aspect ratio.
   *
   * @param eye position of the camera
   * @param target the point in the middle of the picture
   * @param up direction that is up in the picture, of any length
   * @throws IllegalArgumentException if the two points are the same, or {@code up} is along the
   *     view
   */
  public SceneBuilder lookingAt(Vec3 eye, Vec3 target, Vec3 up, Lens lens) {
    return seenFrom(new Viewpoint(eye, target, up, lens));
  }

  /** Sets where the camera stands and looks, with +y up; see {@link #lookingAt}. */
  public SceneBuilder lookingAt(Vec3 eye, Vec3 target, Lens lens) {
    return lookingAt(eye, target, Vec3.Y, lens);
  }

  /**
   * Sets where a pinhole camera stands and looks, with +y up; see {@link #lookingAt}.
   *
   * @param fovDegrees the full vertical angle of view, in degrees, in (0, 180)
   */
  public SceneBuilder lookingAt(Vec3 eye, Vec3 target, double fovDegrees) {
    return lookingAt(eye, target, Lens.pinhole(fovDegrees));
  }

  /** Sets where the camera stands and looks. */
  public SceneBuilder seenFrom(Viewpoint newViewpoint) {
    requireScene("the camera");
    viewpoint = Optional.of(newViewpoint);
    camera = Optional.empty();
    return this;
  }

  /** Sets a camera for films of one aspect ratio. */
  public SceneBuilder seenBy(Camera newCamera) {
    requireScene("the camera");
    camera = Optional.of(Objects.requireNonNull(newCamera, "camera"));
    viewpoint = Optional.empty();
    return this;
  }

  private void requireScene(String what) {
    if (isGroup) {
      throw new IllegalStateException(
          what + ": expected in the scene itself, found in a group; set it outside the group");
    }
  }

  /** Names a material of this scene, for mattes, audits and messages. */
  public SceneBuilder name(Material material, String name) {
    materialNames.put(Objects.requireNonNull(material, "material"), Names.require("name", name));
    return this;
  }

  /**
   * Puts the lights that are added next into a light group; see {@link Layer#LIGHTS}.
   *
   * @param name letters, digits and underscores; empty for no group
   * @throws IllegalArgumentException if the name has other characters
   */
  public SceneBuilder lightGroup(String name) {
    LightGroups.require(name);
    lightGroup = name;
    return this;
  }

  /** Adds a surface that scatters light and does not emit any. */
  public SceneBuilder add(Shape shape, Material material) {
    return surface("", shape, material, Optional.empty(), false);
  }

  /**
   * Adds a surface that scatters light and does not emit any.
   *
   * @param name of the object, at most 60 characters; a number follows if another object has it
   */
  public SceneBuilder add(String name, Shape shape, Material material) {
    return surface(Names.require("name", name), shape, material, Optional.empty(), false);
  }

  /**
   * Adds a surface that emits light. In path mode, it is also sampled as a light. An infinite plane
   * cannot be sampled; it contributes only to paths that hit it.
   *
   * @param material how the surface scatters light; {@link Unlit} if it does not
   */
  public SceneBuilder add(Shape shape, Material material, Emission emission) {
    return surface("", shape, material, Optional.of(emission), false);
  }

  /**
   * Adds an area light: a surface that emits light, does not scatter any, and is sampled as a light
   * in both modes.
   */
  public SceneBuilder addAreaLight(Shape shape, Emission emission) {
    return surface("", shape, Unlit.INSTANCE, Optional.of(emission), true);
  }

  /**
   * Adds an area light that emits the same radiance from all points of its outside.
   *
   * @param name of the object, at most 60 characters; a number follows if another object has it
   */
  public SceneBuilder addAreaLight(String name, Shape shape, Rgb radiance) {
    return surface(
        Names.require("name", name),
        shape,
        Unlit.INSTANCE,
        Optional.of(Emission.of(radiance)),
        true);
  }

  private SceneBuilder surface(
      String name,
      Shape shape,
      Material material,
      Optional<Emission> emission,
      boolean isDeclared) {
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(material, "material");
    nodes.add(new SceneNode.Surface(name, lightGroup, shape, material, emission, isDeclared));
    return this;
  }

  /**
   * Adds a light without a surface, such as a point light or an environment light. Black lights are
   * ignored.
   *
   * @throws IllegalStateException if it is an environment light in a group
   */
  public SceneBuilder add(Light light) {
    if (light instanceof EnvironmentLight) {
      requireScene("an environment light");
    }
    nodes.add(new SceneNode.Lamp(lightGroup, Objects.requireNonNull(light, "light")));
    return this;
  }

  /** Adds a model, for example. */
  public SceneBuilder add(SceneContent content) {
    return add("", Transform.IDENTITY, content);
  }

  /**
   * Adds a model at a place, for example.
   *
   * @param name of the object, at most 60 characters; empty for none
   * @param transform invertible; from the content's space to the space of the scene or group
   * @throws IllegalArgumentException if the transform is singular
   */
  public SceneBuilder add(String name, Transform transform, SceneContent content) {
    Objects.requireNonNull(content, "content");
    nodes.add(
        new SceneNode.Part(
            name.isEmpty() ? name : Names.require("name", name),
            lightGroup,
            invertible(transform),
            content));
    return this;
  }

  /**
   * Adds a group: parts that move together.
   *
   * @param name of the group, unique among the groups of the scene
   * @param transform invertible; from the group's space to the space of the scene or outer group
   * @param parts adds the parts to the builder that it is given
   * @throws IllegalArgumentException if the transform is singular
   */
  public SceneBuilder group(String name, Transform transform, Consumer<SceneBuilder> parts) {
    SceneBuilder group = new SceneBuilder(this);
    parts.accept(group);
    nodes.add(new SceneNode.Group(Names.require("name", name), invertible(transform), group.nodes));
    return this;
  }

  /**
   * Moves a group: replaces its transform.
   *
   * @param group name of a group that was added, in the scene or in another group
   * @param transform invertible; from the group's space to the space of the scene or outer group
   * @throws IllegalArgumentException if there is no such group or the transform is singular
   */
  public SceneBuilder place(String group, Transform transform) {
    List<SceneNode> moved = Groups.placed(nodes, group, invertible(transform));
    nodes.clear();
    nodes.addAll(moved);
    return this;
  }

  private static Transform invertible(Transform transform) {
    if (!transform.isInvertible()) {
      throw new IllegalArgumentException(
          "transform: expected an invertible transform, found a singular one");
    }
    return transform;
  }

  /** Adds a uniform environment light, which lights surfaces in path mode. */
  public SceneBuilder addBackground(Rgb radiance) {
    requireScene("a background");
    nodes.add(new SceneNode.Background(lightGroup, Objects.requireNonNull(radiance, "radiance")));
    return this;
  }

  /** Adds a uniform environment light of white light; see {@link #addBackground(Rgb)}. */
  public SceneBuilder addBackground(double radiance) {
    return addBackground(Rgb.gray(radiance));
  }

  /**
   * Adds ambient irradiance, which every diffuse surface receives uniformly from all directions.
   */
  public SceneBuilder addAmbient(Rgb irradiance) {
    nodes.add(new SceneNode.Ambient(Objects.requireNonNull(irradiance, "irradiance")));
    return this;
  }

  /** Sets the color that the camera sees instead of environment lights, which still give light. */
  public SceneBuilder backplate(Rgb radiance) {
    return backplate(Backplate.plain(radiance));
  }

  /** Sets what the camera sees instead of environment lights, which still give light. */
  public SceneBuilder backplate(Backplate seen) {
    requireScene("the backplate");
    backplate = Optional.of(seen);
    return this;
  }

  /**
   * Returns the scene.
   *
   * @throws IllegalStateException if there is no camera, or two groups have the same name
   */
  public Scene build() {
    requireScene("build");
    if (camera.isEmpty() && viewpoint.isEmpty()) {
      throw new IllegalStateException("camera: expected lookingAt or seenBy, found neither");
    }
    Groups.requireDistinct(nodes);
    SceneDescription description = new SceneDescription(viewpoint, nodes, materialNames, backplate);
    SceneAssembly assembly =
        new SceneAssembly(camera.or(() -> viewpoint.map(v -> v.camera(1))).orElseThrow());
    Placements placements = new Placements(origin.map(Scene::placements).orElse(Placements.NONE));
    new SceneOrder(assembly, placements, materialNames).add(nodes);
    backplate.ifPresent(assembly::backplate);
    return assembly.build(description, placements, origin);
  }

  /** Returns the number of parts, for people. */
  @Override
  public String toString() {
    return "SceneBuilder with " + nodes.size() + " objects, groups, models and lights";
  }
}
