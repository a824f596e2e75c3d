package io.github.lumbre.scene;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.KernelChange;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.SceneDescription;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.Specialization;
import io.github.lumbre.scene.internal.SurfaceNames;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * A complete scene in world space. All threads share it; nothing that it finds ever changes. {@link
 * #builder} builds it in code.
 *
 * <p>A scene has two lists of lights. {@link #lights} holds the declared lights. {@link #emitters}
 * holds all lights of path mode: the declared lights, other emissive surfaces, and the background.
 */
public final class Scene extends OpenScene {
  /**
   * What code built a scene from.
   *
   * @param origin the scene that it continues; empty if there is none
   */
  record Built(SceneDescription description, Placements placements, Optional<Scene> origin) {}

  private final Camera camera;

  /** Where the camera stands; empty if it was given for one aspect ratio. */
  private final Optional<Viewpoint> viewpoint;

  private final Optional<Built> built;
  private final List<Primitive> primitives;

  /** The same primitives, simplified for the inner loop. */
  private final Primitive[] primitiveOfShape;

  private final Hierarchies hierarchies;

  /** The first of {@link #hierarchies}. */
  private final Bvh bvh;

  private final SceneLights lights;
  private final Rgb ambient;
  private final Optional<Backplate> backplate;
  private final double radius;
  private final SurfaceNames names;
  private final Set<Specialization> shortcuts;

  /** Whether rays may pass straight through some surface. */
  private final boolean hasTransparency;

  /** The poses of a scene in motion, in the order of time; empty if it stands still. */
  private final List<Scene> poses;

  Scene(SceneAssembly built, Optional<Built> from) {
    this(built, from, Optional.empty());
  }

  /**
   * @param known the hierarchies of the shapes and lights; empty to build them
   */
  Scene(SceneAssembly built, Optional<Built> from, Optional<Hierarchies> known) {
    camera = built.camera;
    viewpoint = from.flatMap(code -> code.description().viewpoint());
    // The scene that this one continues need not be kept.
    this.built = from.map(b -> new Built(b.description(), b.placements(), Optional.empty()));
    primitives = List.copyOf(built.primitives);
    lights = SceneLights.of(built);
    ambient = built.ambient;
    backplate = built.backplate;
    radius =
        primitives.stream()
            .map(primitive -> primitive.shape().bounds())
            .filter(Bounds3::isFinite)
            .reduce(Bounds3.EMPTY, Bounds3::union)
            .radius();
    hierarchies =
        known
            .or(
                () ->
                    from.flatMap(Built::origin)
                        .filter(other -> other.shapes().equals(shapes()))
                        .map(
                            other -> other.hierarchies.of(lights.all().equals(other.lights.all()))))
            .orElseGet(
                () ->
                    built.isSearchedLater
                        ? Hierarchies.later(shapes(), built.kernel)
                        : Hierarchies.over(shapes(), built.kernel, lights.all()));
    bvh = hierarchies.all();
    names = SurfaceNames.of(built.objectNames, built.materialNames);
    shortcuts = Specialization.of(primitives, emitters().size());
    hasTransparency = primitives.stream().anyMatch(primitive -> !primitive.material().isOpaque());
    poses = List.of();
    primitiveOfShape = primitivesOfShapes();
  }

  /** Creates a copy that shares surfaces and lights. */
  private Scene(
      Scene other,
      Hierarchies hierarchies,
      Set<Specialization> shortcuts,
      Camera camera,
      Optional<Viewpoint> viewpoint,
      SurfaceNames names,
      List<Scene> poses) {
    this.camera = camera;
    this.poses = poses;
    this.names = names;
    this.viewpoint = viewpoint;
    built = other.built;
    primitives = other.primitives;
    this.hierarchies = hierarchies;
    bvh = hierarchies.all();
    lights = other.lights;
    ambient = other.ambient;
    backplate = other.backplate;
    radius = other.radius;
    hasTransparency = other.hasTransparency;
    this.shortcuts = Set.copyOf(shortcuts);
    primitiveOfShape = primitivesOfShapes();
  }

  private Primitive[] primitivesOfShapes() {
    return takes(Specialization.UNIFORM_MATERIALS)
        ? primitives.stream().map(Primitive::simplified).toArray(Primitive[]::new)
        : primitives.toArray(Primitive[]::new);
  }

  SceneInside inside() {
    return new SceneInside(description(), names, lights.groups(), shortcuts, this::without);
  }

  /** Returns the same scene without a specialization. Its renders are bit-identical. */
  Scene without(Specialization shortcut) {
    Set<Specialization> others =
        shortcuts.stream().filter(other -> other != shortcut).collect(Collectors.toSet());
    return new Scene(
        this, hierarchies, others, camera, viewpoint, names, posed(s -> s.without(shortcut)));
  }

  /**
   * Returns the same scene with another traversal kernel. Its renders are bit-identical.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public Scene searchedBy(Kernel kernel) {
    Hierarchies others = Hierarchies.over(shapes(), kernel, lights.all());
    return searchedIn(others, posed(pose -> pose.searchedBy(kernel)));
  }

  /**
   * Returns the same scene with a slower traversal that counts visited nodes; see {@link
   * Bvh#counting}.
   */
  public Scene counting(LongAdder visits) {
    Hierarchies others = Hierarchies.counting(shapes(), visits, lights.all());
    return searchedIn(others, posed(pose -> pose.counting(visits)));
  }

  private Scene searchedIn(Hierarchies others, List<Scene> newPoses) {
    return new Scene(this, others, shortcuts, camera, viewpoint, names, newPoses);
  }

  /** Returns the poses after a change; one that stands for several is changed once. */
  private List<Scene> posed(UnaryOperator<Scene> change) {
    Map<Scene, Scene> changed = new IdentityHashMap<>();
    return poses.stream().map(pose -> changed.computeIfAbsent(pose, change)).toList();
  }

  /** Returns whether {@link #changeKernel} has something to do, if vectors are available. */
  public boolean mayChangeKernel() {
    return changes().stream().anyMatch(KernelChange::isPossible);
  }

  /**
   * Changes from plain Java to the vector kernel if this becomes faster; see {@link KernelChange}.
   * Takes a few seconds; renders may go on meanwhile, and their pictures do not change. Long
   * renders call it.
   *
   * @param isWanted whether to continue; the work stops soon after it returns false
   * @throws InterruptedException if the thread is interrupted; nothing has changed then
   */
  public void changeKernel(BooleanSupplier isWanted) throws InterruptedException {
    for (KernelChange change : changes()) {
      change.run(isWanted);
    }
  }

  private List<KernelChange> changes() {
    return poses().stream().map(pose -> pose.hierarchies.change()).distinct().toList();
  }

  private List<Shape> shapes() {
    return primitives.stream().map(Primitive::shape).toList();
  }

  boolean takes(Specialization shortcut) {
    return shortcuts.contains(shortcut);
  }

  /**
   * Returns a scene in motion: its pictures are the means of the pictures of poses. Of each pixel's
   * samples, number i shows pose i modulo the number of poses, and every pixel gets equally many
   * samples of each. Everything but samples, such as lines, names and guiding, is that of the
   * middle pose.
   *
   * @param poses in the order of time; their number is a power of two, up to {@link
   *     RenderSettings#MAX_POSES}. Scenes that share meshes and hierarchies need little memory
   */
  public static Scene inMotion(List<Scene> poses) {
    if (!Setting.POSES.type().accepts(poses.size())) {
      throw new IllegalArgumentException(
          "poses: expected " + Setting.POSES.type().expected() + ", found " + poses.size());
    }
    Scene middle = poses.get(poses.size() / 2);
    return new Scene(
        middle,
        middle.hierarchies,
        middle.shortcuts,
        middle.camera,
        middle.viewpoint,
        middle.names,
        poses.size() == 1 ? List.of() : List.copyOf(poses));
  }

  /** Returns the poses of a scene in motion, in the order of time; itself if it stands still. */
  public List<Scene> poses() {
    return poses.isEmpty() ? List.of(this) : poses;
  }

  /** Returns a builder of a scene in code. */
  public static SceneBuilder builder() {
    return new SceneBuilder();
  }

  /**
   * Returns a builder that continues this scene. Its scenes share meshes and textures with this
   * one, and the hierarchies of everything that does not move.
   *
   * @throws IllegalStateException if the scene was read from a file
   */
  public SceneBuilder toBuilder() {
    return new SceneBuilder(
        this,
        description()
            .orElseThrow(
                () ->
                    new IllegalStateException(
                        "scene: expected one that was built in code, found one from a file")));
  }

  /** Returns this scene, seen by another camera. Both share all surfaces and lights. */
  public Scene seenBy(Camera newCamera) {
    return seenBy(newCamera, Optional.empty());
  }

  /** Returns this scene, which shares everything, seen from elsewhere. */
  public Scene seenFrom(Viewpoint viewpoint) {
    return seenBy(viewpoint.camera(1), Optional.of(viewpoint));
  }

  private Scene seenBy(Camera newCamera, Optional<Viewpoint> newViewpoint) {
    return new Scene(
        this,
        hierarchies,
        shortcuts,
        newCamera,
        newViewpoint,
        names,
        posed(pose -> pose.seenBy(newCamera, newViewpoint)));
  }

  /**
   * Returns the scene for films of an aspect ratio: with the camera of its viewpoint. A scene that
   * was given a camera keeps it.
   *
   * @param aspect width of the film over its height
   */
  public Scene framed(double aspect) {
    return viewpoint.map(from -> seenBy(from.camera(aspect), viewpoint)).orElse(this);
  }

  /**
   * Returns this scene with the names of another assembly of it.
   *
   * @throws IllegalArgumentException if the numbers of primitives or emitters differ
   */
  public Scene named(SceneAssembly same) {
    if (same.primitiveCount() != primitives.size() || same.emitterCount() != emitters().size()) {
      String expected = primitives.size() + " primitives and " + emitters().size() + " emitters";
      String found = same.primitiveCount() + " and " + same.emitterCount();
      throw new IllegalArgumentException("same: expected " + expected + ", found " + found);
    }
    SurfaceNames others = SurfaceNames.of(same.objectNames, same.materialNames);
    return new Scene(
        this, hierarchies, shortcuts, camera, viewpoint, others, posed(pose -> pose.named(same)));
  }

  /** Returns the description that the scene was built from; empty if it was read from a file. */
  Optional<SceneDescription> description() {
    return built.map(from -> from.description().seenFrom(viewpoint));
  }

  /** Returns the parts at their places; none if the scene was read from a file. */
  Placements placements() {
    return built.map(Built::placements).orElse(Placements.NONE);
  }

  /** Returns the hierarchy over all shapes. */
  Bvh hierarchy() {
    return bvh;
  }

  /** Returns the camera. */
  public Camera camera() {
    return camera;
  }

  /** Returns the primitives; a shape's number is its index in this list. */
  public List<Primitive> primitives() {
    return primitives;
  }

  /** Returns the declared lights, without black ones. */
  public List<Light> lights() {
    return lights.declared();
  }

  /** Returns all lights that can be sampled in path mode, without black ones. */
  public List<Light> emitters() {
    return lights.emitters();
  }

  /** Returns the emitters that are environment lights, in the same order. */
  public List<EnvironmentLight> environments() {
    return lights.environments();
  }

  /**
   * Returns the radius, in world units, of a sphere around all bounded shapes; 0 if there are none.
   */
  public double radius() {
    return radius;
  }

  /**
   * Returns the ambient irradiance, which every diffuse surface receives uniformly from all
   * directions.
   */
  public Rgb ambient() {
    return ambient;
  }

  /**
   * Returns the name of the object that a primitive is part of: that of the scene file, the model
   * or {@link SceneBuilder#add(String, Shape, Material)}; made from its number without one.
   *
   * @param primitive its number in {@link #primitives}
   * @throws IndexOutOfBoundsException if there is no such primitive
   */
  public String objectName(int primitive) {
    return names.object(Objects.checkIndex(primitive, primitives.size()));
  }

  /** Returns the name of the material of a primitive; see {@link #objectName}. */
  public String materialName(int primitive) {
    return names.material(Objects.checkIndex(primitive, primitives.size()));
  }

  /** Returns the names of the objects and materials of the primitives. */
  SurfaceNames names() {
    return names;
  }

  /** Returns what the camera sees instead of environment lights; empty if it sees these. */
  public Optional<Backplate> backplate() {
    return backplate;
  }

  /**
   * Finds the nearest hit along a ray and stores it.
   *
   * @return whether there is a hit
   */
  public boolean intersect(Ray ray, NearestHit hit) {
    return bvh.intersect(ray, hit);
  }

  /**
   * Finds the nearest hit along the ray that {@code hit} was last aimed along, and stores it.
   *
   * @return whether there is a hit
   */
  public boolean intersect(NearestHit hit) {
    return bvh.intersect(hit);
  }

  /** Returns the primitive of a hit that {@link #intersect} found. */
  public Primitive primitiveAt(NearestHit hit) {
    return primitiveOfShape[hit.shape()];
  }

  /** Returns the surface of a hit that {@link #intersect} found. */
  public SurfaceHit surfaceAt(NearestHit hit) {
    return primitiveAt(hit).shape().surfaceAt(hit);
  }

  /**
   * Returns the index in {@link #emitters} of the hit primitive, or -1 if it is not sampled as a
   * light.
   */
  public int emitterAt(NearestHit hit) {
    return lights.ofPrimitive(hit.shape());
  }

  /**
   * Returns the index in {@link #emitters} of the environment light with the given index in {@link
   * #environments}.
   */
  public int emitterOfEnvironment(int environment) {
    return lights.ofEnvironment(environment);
  }

  /**
   * Returns the index in {@link #emitters} of the light with the given index in {@link #lights}; -1
   * if it is not there.
   */
  public int emitterOfLight(int light) {
    return lights.ofLight(light);
  }

  /** Returns whether rays may pass straight through some surface. */
  public boolean hasTransparency() {
    return hasTransparency;
  }

  /** Returns whether the camera sees only the shadows of some surface. */
  public boolean catchesShadows() {
    return hasTransparency && primitives.stream().anyMatch(p -> p.material().catchesShadows());
  }

  /** Returns whether any shape blocks the ray that {@code scratch} was last aimed along. */
  public boolean isOccluded(NearestHit scratch) {
    return bvh.isOccluded(scratch);
  }

  /**
   * Returns whether any shape blocks the ray that {@code scratch} was last aimed along, which ends
   * at a light.
   *
   * @param isNear whether the ray ends at a light at a finite distance, so that fewer shapes may
   *     block it
   */
  public boolean isLightOccluded(NearestHit scratch, boolean isNear) {
    return (isNear ? hierarchies.blockers() : bvh).isOccluded(scratch);
  }

  /** Returns the radiance of all environment lights in a unit direction, in world space. */
  public Rgb background(Vec3 direction) {
    return lights.background(direction);
  }

  /** Returns the numbers of objects and lights, for people. */
  @Override
  public String toString() {
    return "Scene of " + primitives.size() + " objects and " + lights().size() + " lights";
  }
}
