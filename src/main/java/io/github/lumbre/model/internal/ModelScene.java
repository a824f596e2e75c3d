package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshAttributes;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelSurface.Emitter;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Turns a model into parts of a scene. Models are right-handed and scenes left-handed, so that the
 * transform into the scene includes a reflection of z; see {@link #TO_LEFT_HANDED}.
 */
public final class ModelScene {
  /** Maps a right-handed space to a left-handed one: (x, y, -z). */
  public static final Transform TO_LEFT_HANDED = Transform.scale(new Vec3(1, 1, -1));

  private static final String INSIDE_OUT =
      "the mesh is one-sided and inside out: it is seen from inside only, where no light from"
          + " outside comes";

  private static final double MIN_RADIUS = 1e-150;
  private static final double MAX_RADIUS = 1e150;

  private final Model model;
  private final Transform toWorld;
  private final Kernel kernel;
  private final ModelMaterials materials;

  /** A geometry, compared by identity, and the coordinates whose tangents it gets. */
  private record MeshKey(ModelGeometry geometry, Optional<MapCoordinates> tangents) {
    @Override
    public boolean equals(Object other) {
      return other instanceof MeshKey key
          && key.geometry == geometry
          && key.tangents.equals(tangents);
    }

    @Override
    public int hashCode() {
      return 31 * System.identityHashCode(geometry) + tangents.hashCode();
    }
  }

  /** Points, compared by identity, and the radius of their spheres in local space. */
  private record CloudKey(ModelGeometry geometry, double radius) {
    @Override
    public boolean equals(Object other) {
      return other instanceof CloudKey key && key.geometry == geometry && key.radius == radius;
    }

    @Override
    public int hashCode() {
      return 31 * System.identityHashCode(geometry) + Double.hashCode(radius);
    }
  }

  private final Map<MeshKey, TriangleMesh> meshes;
  private final Map<CloudKey, Shape> clouds;
  private final Map<TriangleMesh, SharedMesh> shared;

  /** On which side the fronts of one-sided meshes are that are not closed; see {@link BodySide}. */
  private final Map<ModelGeometry, Integer> sides;

  /** The surfaces of parts that do not move between poses, once they are made. */
  private final Map<ModelPart, ModelSurface> made;

  /** The number of parts of each mesh, in all poses. */
  private final Map<ModelGeometry, Integer> uses;

  /** Whether all meshes are shared, also those that the model places once. */
  private final boolean sharesAll;

  /**
   * @param toWorld from the model's world space to the scene's, invertible
   * @param kernel traversal kernel of shared meshes
   * @param limits of all pictures
   * @param sharesAll whether all meshes have hierarchies in their local space, also those that the
   *     model places once
   */
  public ModelScene(
      Model model, Transform toWorld, Kernel kernel, Limits limits, boolean sharesAll) {
    this(model, toWorld, kernel, limits, sharesAll, new DecodedPictures());
  }

  /**
   * @param pictures decoded for other poses of the model
   */
  public ModelScene(
      Model model,
      Transform toWorld,
      Kernel kernel,
      Limits limits,
      boolean sharesAll,
      DecodedPictures pictures) {
    this.model = Objects.requireNonNull(model, "model");
    this.toWorld = Objects.requireNonNull(toWorld, "toWorld");
    this.kernel = Objects.requireNonNull(kernel, "kernel");
    materials = new ModelMaterials(toWorld, limits, pictures);
    meshes = new ConcurrentHashMap<>();
    clouds = new ConcurrentHashMap<>();
    shared = Collections.synchronizedMap(new IdentityHashMap<>());
    sides = Collections.synchronizedMap(new IdentityHashMap<>());
    made = new IdentityHashMap<>();
    uses = uses(model);
    this.sharesAll = sharesAll;
  }

  private ModelScene(
      ModelScene other,
      Model model,
      Transform toWorld,
      ModelMaterials materials,
      Map<ModelPart, ModelSurface> made,
      boolean sharesAll) {
    this.model = model;
    this.toWorld = toWorld;
    kernel = other.kernel;
    this.materials = materials;
    meshes = other.meshes;
    clouds = other.clouds;
    shared = other.shared;
    sides = other.sides;
    this.made = made;
    uses = other.uses;
    this.sharesAll = sharesAll;
  }

  private static Map<ModelGeometry, Integer> uses(Model model) {
    Map<ModelPart, Boolean> parts = new IdentityHashMap<>();
    model.parts().forEach(part -> parts.put(part, true));
    model.poses().forEach(pose -> pose.parts().forEach(part -> parts.put(part, true)));
    Map<ModelGeometry, Integer> uses = new IdentityHashMap<>();
    parts.keySet().forEach(part -> uses.merge(part.geometry(), 1, Integer::sum));
    return uses;
  }

  /**
   * Returns a pose of the model, which is in motion. Poses share the surfaces that do not move, and
   * all meshes that move and keep their shape.
   */
  public ModelScene posed(Model pose) {
    return new ModelScene(this, pose, toWorld, materials, made, sharesAll);
  }

  /**
   * Returns the model at another place, with the same meshes and textures.
   *
   * @param newToWorld from the model's world space to the scene's, invertible
   * @param sharing whether all meshes have hierarchies in their local space, which are built once
   */
  public ModelScene at(Transform newToWorld, boolean sharing) {
    return new ModelScene(
        this, model, newToWorld, materials.at(newToWorld), new IdentityHashMap<>(), sharing);
  }

  /**
   * Decodes the textures of all parts.
   *
   * @throws ModelFormatException if one is too large
   */
  public void decode() throws ModelFormatException {
    for (ModelPart part : model.parts()) {
      materials.of(part.material(), true);
      materials.emission(part.material(), part.geometry().colors().length > 0);
    }
  }

  /**
   * Returns the surfaces, in the order of the model's parts. Parts without a triangle of positive
   * area are left out, and so are pictures that cannot be decoded.
   *
   * @throws ModelFormatException if a picture is too large, or a part is placed by a transform that
   *     is not invertible
   */
  public List<ModelSurface> surfaces() throws ModelFormatException {
    List<ModelSurface> surfaces = new ArrayList<>();
    for (ModelPart part : model.parts()) {
      ModelSurface known = made.get(part);
      Optional<ModelSurface> surface = known == null ? surface(part) : Optional.of(known);
      surface.ifPresent(
          found -> {
            made.put(part, found);
            surfaces.add(found);
          });
    }
    return surfaces;
  }

  private Optional<ModelSurface> surface(ModelPart part) throws ModelFormatException {
    if (part.geometry().isPoints()) {
      return Optional.of(points(part));
    }
    TriangleMesh mesh = mesh(part);
    if (mesh.triangleCount() == 0) {
      return Optional.empty();
    }
    Transform partToWorld = toWorld.times(part.toWorld());
    ModelReach.requireInvertible(part, partToWorld);
    Shape shape = shape(mesh, partToWorld, sharesAll || uses.get(part.geometry()) > 1);
    boolean isOneSided = !part.material().doubleSided();
    boolean isClosed = isOneSided && shape.isClosed();
    if (isOneSided && !isClosed && side(part.geometry()) < 0) {
      materials.warn(part.location(), INSIDE_OUT);
    }
    return Optional.of(
        new ModelSurface(
            part,
            shape,
            materials.of(part.material(), isClosed),
            materials
                .emission(part.material(), part.geometry().colors().length > 0)
                .map(
                    emission ->
                        part.material().flat()
                            ? List.of(new Emitter(shape, emission))
                            : EmissiveTriangles.of(mesh, shape, partToWorld, emission))
                .orElse(List.of())));
  }

  private int side(ModelGeometry geometry) {
    return sides.computeIfAbsent(geometry, BodySide::of);
  }

  /** Returns points as one surface of spheres. */
  private ModelSurface points(ModelPart part) throws ModelFormatException {
    Transform partToWorld = toWorld.times(part.toWorld());
    ModelReach.requireInvertible(part, partToWorld);
    double scale = part.toWorld().vector(Vec3.X).length();
    // Copies of one cloud often have the same scale, up to rounding.
    double rounded = (float) scale;
    double radius =
        model.pointRadius() / (rounded > 0 && Double.isFinite(rounded) ? rounded : scale);
    Shape shape =
        clouds
            .computeIfAbsent(new CloudKey(part.geometry(), radius), this::cloud)
            .transformed(partToWorld);
    Optional<Emission> emission =
        materials.emission(part.material(), part.geometry().colors().length > 0);
    return new ModelSurface(
        part,
        shape,
        materials.of(part.material(), true),
        emission.stream().map(light -> new Emitter(shape, light)).toList());
  }

  private Shape cloud(CloudKey key) {
    ModelGeometry points = key.geometry;
    return Sphere.cloud(
        points.positions(),
        Math.max(MIN_RADIUS, Math.min(key.radius, MAX_RADIUS)),
        points.uv0(),
        new MeshAttributes(points.tangents(), points.uv1(), points.colors()),
        kernel);
  }

  /** Returns warnings of what {@link #surfaces} has left out, and of surfaces that are dark. */
  public List<String> warnings() {
    return materials.warnings();
  }

  /** Returns the number of texels of the pictures that {@link #surfaces} has decoded. */
  public long texels() {
    return materials.texels();
  }

  /** Returns the number of pictures that {@link #surfaces} has decoded. */
  public int pictures() {
    return materials.pictures();
  }

  private TriangleMesh mesh(ModelPart part) {
    Optional<MapCoordinates> missing = MapCoordinates.missing(part.material(), part.geometry());
    return meshes.computeIfAbsent(
        new MeshKey(part.geometry(), missing),
        key -> mesh(missing.map(m -> m.withTangents(key.geometry)).orElse(key.geometry)));
  }

  private TriangleMesh mesh(ModelGeometry geometry) {
    boolean isPlain =
        geometry.tangents().length == 0
            && geometry.uv1().length == 0
            && geometry.colors().length == 0;
    return TriangleMesh.of(
        geometry.positions(),
        geometry.normals(),
        geometry.uv0(),
        geometry.indices(),
        isPlain
            ? MeshAttributes.NONE
            : new MeshAttributes(geometry.tangents(), geometry.uv1(), geometry.colors()),
        model.front());
  }

  private Shape shape(TriangleMesh mesh, Transform partToWorld, boolean isShared) {
    return isShared
        ? new MeshInstance(
            shared.computeIfAbsent(mesh, m -> new SharedMesh(m, kernel)), partToWorld)
        : Mesh.baked(mesh, partToWorld);
  }

  /** Returns the lights, in the order of the file. Their range is ignored: light never ends. */
  public List<Light> lights() {
    return model.lights().stream().map(this::light).toList();
  }

  private Light light(ModelLight light) {
    Transform transform = toWorld.times(light.toWorld());
    Vec3 axis = transform.vector(new Vec3(0, 0, -1)).normalized();
    PointLight point =
        new PointLight(transform.point(Vec3.ZERO), light.intensity(), Falloff.INVERSE_SQUARE);
    return switch (light.kind()) {
      case DIRECTIONAL -> new DirectionalLight(axis, light.intensity());
      case POINT -> point;
      case SPOT -> {
        double outer = Math.toDegrees(light.outerCone());
        double inner = Math.min(outer, Math.toDegrees(light.innerCone()));
        yield new SpotLight(point, axis, outer, outer - inner);
      }
    };
  }

  /** Returns the right, up and forward directions of a camera's space. */
  public static Frame axes(Transform cameraToWorld) {
    Vec3 forward = cameraToWorld.vector(new Vec3(0, 0, -1)).normalized();
    Vec3 up = cameraToWorld.vector(Vec3.Y);
    Vec3 upright = up.plus(-up.dot(forward), forward).normalized();
    return new Frame(upright.cross(forward), upright, forward);
  }
}
