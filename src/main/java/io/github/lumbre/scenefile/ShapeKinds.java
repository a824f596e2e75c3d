package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/** The shapes of scene files. */
final class ShapeKinds {
  static final Family<BiFunction<Placed, ShapeReader, Optional<Shape>>> FAMILY =
      new Family<>("shapeType", Optional.empty(), "a shape", ObjectKeys.OF_EMITTERS);

  static final Key<Integer> MATERIAL = Key.id("materialID");
  static final Key<Integer> MESH = Key.id("meshId");
  static final Key<Boolean> SHARED =
      Key.flag("shared", false, "Whether the mesh keeps a hierarchy in its own space.").omitted();

  static final String PLANE = "Plane";

  /** The kind whose meshes several objects may share. */
  static final String MESHES = "Mesh";

  private static final Key<Boolean> TWO_SIDED =
      Key.flag("twoSided", false, "Whether it can be hit from below.");

  static {
    Key<Double> radius = size("radius", "In scene units.");
    kind("Sphere", Sphere.class, at -> new Sphere(at.toWorld(), at.get(radius)))
        .with(radius, Sphere::radius)
        .placed(Sphere::toWorld);
    planes();
    Key<Double> width = size("width", "Along x.");
    Key<Double> height = size("height", "Along y.");
    Key<Double> depth = size("depth", "Along z.");
    kind(
            "Cube",
            Box.class,
            at -> new Box(at.toWorld(), at.get(width), at.get(height), at.get(depth)))
        .with(width, box -> box.size().x())
        .with(height, box -> box.size().y())
        .with(depth, box -> box.size().z())
        .placed(Box::toWorld);
    meshes();
    FAMILY.refuse("SphereCloud", "a shape that scenes have", "one of Sphere.cloud");
    FAMILY.refuse("Item", "a shape that scenes have", "one of Sphere.cloud");
  }

  private ShapeKinds() {}

  static Key<Double> size(String name, String meaning) {
    return Key.number(name, Range.SIZE, 1, meaning);
  }

  private static <S extends Shape> Kind<BiFunction<Placed, ShapeReader, Optional<Shape>>, S> kind(
      String name, Class<S> type, Function<Placed, S> reading) {
    return FAMILY
        .kind(name, type, (at, reader) -> Optional.of(reading.apply(at)))
        .with(MATERIAL);
  }

  private static void planes() {
    Key<Boolean> finite = Key.flag("finite", false, "Whether it has a width and a height.");
    Key<Double> width = size("width", "Along x.");
    Key<Double> height = size("height", "Along z.");
    kind(
            PLANE,
            Rectangle.class,
            at -> new Rectangle(at.toWorld(), at.get(width), at.get(height), at.get(TWO_SIDED)))
        .when(finite)
        .with(width, Rectangle::width)
        .with(height, Rectangle::height)
        .with(TWO_SIDED, Rectangle::isTwoSided)
        .placed(Rectangle::toWorld);
    kind(PLANE, Plane.class, at -> new Plane(at.toWorld(), at.get(TWO_SIDED)))
        .with(finite)
        .with(TWO_SIDED, Plane::isTwoSided)
        .placed(Plane::toWorld);
  }

  /** Meshes: an asset for each that is not shared, since readers would share one that two use. */
  private static void meshes() {
    BiFunction<Placed, ShapeReader, Optional<Shape>> reading = (at, reader) -> reader.mesh(at);
    FAMILY
        .kind(MESHES, MeshInstance.class, reading)
        .with(MATERIAL)
        .with(MESH, (one, out) -> out.mesh(one.shared(), "", one.shared().mesh()))
        .placed(MeshInstance::toWorld)
        .with(SHARED, one -> true);
    FAMILY
        .kind(MESHES, Mesh.class, reading)
        .with(MATERIAL)
        .with(MESH, (mesh, out) -> out.mesh(mesh, out.unique(), source(mesh).mesh()))
        .placed(mesh -> source(mesh).toWorld());
  }

  private static Mesh.Source source(Mesh mesh) {
    return mesh.source()
        .orElseThrow(() -> new Unwritable("a mesh of Mesh.of", "one of Mesh.baked"));
  }
}
