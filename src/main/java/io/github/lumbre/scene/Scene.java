package io.github.lumbre.scene;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.Collectors;

/**
 * The world: complete, immutable, and shared by all threads. Built by {@link SceneBuilder}.
 *
 * <p>Two lists of lights: {@link #lights} are those that the scene calls lights, {@link #emitters}
 * add what else shines if all light is followed (glowing surfaces, the background).
 */
public final class Scene {
  private final Camera camera;
  private final List<Primitive> primitives;

  /** The same, simplified for the inner loop. */
  private final Primitive[] primitiveOfShape;

  private final Bvh bvh;
  private final List<Light> lights;
  private final List<Light> emitters;
  private final List<EnvironmentLight> environments;

  /** The index among the emitters of each environment light, and of each light. */
  private final int[] emitterOfEnvironment, emitterOfLight;

  private final Rgb ambient;
  private final double radius;

  /** The index among the emitters of each primitive that is one. */
  private final int[] emitterOfPrimitive;

  private final Set<Specialization> shortcuts;

  Scene(SceneBuilder built) {
    camera = built.camera;
    primitives = List.copyOf(built.primitives);
    lights = List.copyOf(built.lights);
    emitters = List.copyOf(built.emitters);
    ambient = built.ambient;
    radius =
        primitives.stream()
            .map(primitive -> primitive.shape().bounds())
            .filter(Bounds3::isFinite)
            .reduce(Bounds3.EMPTY, Bounds3::union)
            .radius();
    bvh = Bvh.over(shapes(), built.kernel());
    environments =
        emitters.stream()
            .filter(EnvironmentLight.class::isInstance)
            .map(EnvironmentLight.class::cast)
            .toList();
    emitterOfEnvironment = indices(environments, emitters);
    emitterOfLight = indices(lights, emitters);
    emitterOfPrimitive = new int[primitives.size()];
    for (int i = 0; i < primitives.size(); i++) {
      emitterOfPrimitive[i] = built.emitterOfPrimitive.getOrDefault(i, -1);
    }
    shortcuts = shortcuts();
    primitiveOfShape = primitivesOfShapes();
  }

  private Scene(Scene other, Bvh bvh, Set<Specialization> shortcuts) {
    camera = other.camera;
    primitives = other.primitives;
    this.bvh = bvh;
    lights = other.lights;
    emitters = other.emitters;
    environments = other.environments;
    emitterOfEnvironment = other.emitterOfEnvironment;
    emitterOfLight = other.emitterOfLight;
    ambient = other.ambient;
    radius = other.radius;
    emitterOfPrimitive = other.emitterOfPrimitive;
    this.shortcuts = Set.copyOf(shortcuts);
    primitiveOfShape = primitivesOfShapes();
  }

  /** Returns the indices of some lights among all, which are in the same order; -1 if missing. */
  private static int[] indices(List<? extends Light> some, List<Light> all) {
    int[] indices = new int[some.size()];
    int next = 0;
    for (int i = 0; i < indices.length; i++) {
      int found = all.subList(next, all.size()).indexOf(some.get(i));
      indices[i] = found < 0 ? -1 : next + found;
      next = Math.max(next, indices[i] + 1);
    }
    return indices;
  }

  private Set<Specialization> shortcuts() {
    Set<Specialization> all = EnumSet.noneOf(Specialization.class);
    if (primitives.stream().anyMatch(primitive -> primitive.material().isUniform())) {
      all.add(Specialization.UNIFORM_MATERIALS);
    }
    if (emitters.size() == 1) {
      all.add(Specialization.ONE_EMITTER);
    }
    return Set.copyOf(all);
  }

  private Primitive[] primitivesOfShapes() {
    return takes(Specialization.UNIFORM_MATERIALS)
        ? primitives.stream().map(Primitive::simplified).toArray(Primitive[]::new)
        : primitives.toArray(Primitive[]::new);
  }

  /** Returns the same scene, of which a render does all the work that a shortcut leaves out. */
  public Scene without(Specialization shortcut) {
    return new Scene(
        this,
        bvh,
        shortcuts.stream()
            .filter(taken -> taken != shortcut)
            .collect(Collectors.toUnmodifiableSet()));
  }

  /**
   * Returns the same scene, whose hits are found by another kernel.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public Scene searchedBy(Kernel kernel) {
    return new Scene(this, Bvh.over(shapes(), kernel), shortcuts);
  }

  /**
   * Returns the same scene, slower to search, which counts the nodes of its hierarchy: see {@link
   * Bvh#counting}.
   */
  public Scene counting(LongAdder visits) {
    return new Scene(this, Bvh.counting(shapes(), visits), shortcuts);
  }

  private List<Shape> shapes() {
    return primitives.stream().map(Primitive::shape).toList();
  }

  /** Tells whether the scene does not require some work. */
  public boolean takes(Specialization shortcut) {
    return shortcuts.contains(shortcut);
  }

  /** Returns a builder of a scene seen by the given camera. */
  public static SceneBuilder seenBy(Camera camera) {
    return new SceneBuilder(camera);
  }

  public Camera camera() {
    return camera;
  }

  public List<Primitive> primitives() {
    return primitives;
  }

  /** Returns the lights that the scene calls lights, black ones left out. */
  public List<Light> lights() {
    return lights;
  }

  /** Returns all that shines and can be sampled, black ones left out. */
  public List<Light> emitters() {
    return emitters;
  }

  /** Returns those emitters that are infinitely far all around. */
  public List<EnvironmentLight> environments() {
    return environments;
  }

  /** Returns the radius of a sphere around everything finite; 0 if there is nothing. */
  public double radius() {
    return radius;
  }

  /** Returns the irradiance that reaches every diffuse surface from nowhere in particular. */
  public Rgb ambient() {
    return ambient;
  }

  /** Finds what a ray meets first; tells whether there is anything. */
  public boolean intersect(Ray ray, NearestHit hit) {
    return bvh.intersect(ray, hit);
  }

  /** Finds what the ray that {@code hit} was just aimed by meets first. */
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
   * Returns the index among {@link #emitters} of the primitive that was hit, or -1 if it is not
   * sampled as a light.
   */
  public int emitterAt(NearestHit hit) {
    return emitterOfPrimitive[hit.shape()];
  }

  /** Returns the index among {@link #emitters} of an environment light, by its own index. */
  public int emitterOfEnvironment(int environment) {
    return emitterOfEnvironment[environment];
  }

  /** Returns the index among {@link #emitters} of a light, by its index among {@link #lights}. */
  public int emitterOfLight(int light) {
    return emitterOfLight[light];
  }

  /** Tells whether anything lies on a ray. */
  public boolean isOccluded(Ray ray, NearestHit scratch) {
    return bvh.isOccluded(ray, scratch);
  }

  /** Tells whether anything lies on the ray that {@code scratch} was just aimed by. */
  public boolean isOccluded(NearestHit scratch) {
    return bvh.isOccluded(scratch);
  }

  /** Returns what arrives along a unit direction from beyond everything. */
  public Rgb background(Vec3 direction) {
    Rgb sum = Rgb.BLACK;
    for (EnvironmentLight environment : environments) {
      sum = sum.plus(environment.from(direction));
    }
    return sum;
  }
}
