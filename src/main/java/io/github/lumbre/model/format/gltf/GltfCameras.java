package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelCamera;
import java.util.Optional;
import java.util.OptionalDouble;

/** The cameras of a glTF file (glTF 2.0, section 3.10). */
final class GltfCameras {
  /** The largest half size of a parallel projection: its square must not overflow. */
  private static final double MAX_SIZE = 1e150;

  /** The largest deviation of a length from 1, as left by rounding. */
  private static final double ROUNDING = 1e-6;

  private final GltfDocument document;
  private final GltfValues values;

  GltfCameras(GltfDocument document) {
    this.document = document;
    values = new GltfValues(document.warnings(), "camera");
  }

  /**
   * Returns the camera of a node; empty, with a warning, if it lacks what it needs.
   *
   * @param place its axes may have any lengths
   */
  Optional<ModelCamera> camera(GltfNode node, GltfMatrix place) throws ModelFormatException {
    GltfJson json = document.section("cameras").get(node.camera().getAsInt());
    String name = node.name().isEmpty() ? values.name(json) : node.name();
    return lens(json)
        .map(
            lens ->
                new ModelCamera(name, node.location() + ".camera", lens, toWorld(lens, place)));
  }

  private static Transform toWorld(ModelCamera.Lens lens, GltfMatrix place) {
    Transform toWorld = place.toTransform();
    boolean isScaled =
        Math.abs(toWorld.vector(Vec3.X).length() - 1) > ROUNDING
            || Math.abs(toWorld.vector(Vec3.Y).length() - 1) > ROUNDING;
    return lens instanceof ModelCamera.Parallel && isScaled
        ? place.withAxesOf(place.orientation()).toTransform()
        : toWorld;
  }

  private Optional<ModelCamera.Lens> lens(GltfJson camera) {
    String type = camera.find("type").filter(JsonValue::isString).map(JsonValue::text).orElse("");
    if (!type.equals("perspective") && !type.equals("orthographic")) {
      values.leftOut(camera, "type", "\"perspective\" or \"orthographic\"");
      return Optional.empty();
    }
    Optional<GltfJson> json = camera.find(type).filter(JsonValue::isObject).map(GltfJson::new);
    if (json.isEmpty()) {
      values.leftOut(camera, type, "an object");
      return Optional.empty();
    }
    return type.equals("perspective") ? perspective(json.get()) : parallel(json.get());
  }

  private Optional<ModelCamera.Lens> perspective(GltfJson json) {
    double fov = stated(json, "yfov");
    if (!(Math.toDegrees(fov) > 0 && Math.toDegrees(fov) < 180)) {
      values.leftOut(json, "yfov", fov > 0 ? "less than pi" : "a number > 0");
      return Optional.empty();
    }
    OptionalDouble aspect = values.positive(json, "aspectRatio", "that of the picture");
    return Optional.of(new ModelCamera.Perspective(fov, aspect));
  }

  private Optional<ModelCamera.Lens> parallel(GltfJson json) {
    OptionalDouble width = half(json, "xmag");
    OptionalDouble height = half(json, "ymag");
    return width.isPresent() && height.isPresent()
        ? Optional.of(new ModelCamera.Parallel(width.getAsDouble(), height.getAsDouble()))
        : Optional.empty();
  }

  private OptionalDouble half(GltfJson json, String member) {
    double size = stated(json, member);
    if (!(Math.abs(size) > 0 && Math.abs(size) <= MAX_SIZE)) {
      values.leftOut(json, member, "a number > 0 and at most 1e150");
      return OptionalDouble.empty();
    }
    if (size < 0) {
      document.warnings().add(json.location(member), "negative; its absolute value is used");
    }
    return OptionalDouble.of(Math.abs(size));
  }

  /** Returns a number that must exist; NaN if it does not. */
  private static double stated(GltfJson json, String member) {
    return json.find(member).filter(GltfJson::isFinite).map(JsonValue::number).orElse(Double.NaN);
  }
}
