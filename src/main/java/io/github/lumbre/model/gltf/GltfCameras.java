package io.github.lumbre.model.gltf;

import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelCamera;
import java.util.List;
import java.util.OptionalDouble;

/** The cameras of a glTF file (glTF 2.0, section 3.10). */
record GltfCameras(GltfDocument document) {
  ModelCamera camera(GltfNode node, Transform toWorld) throws ModelFormatException {
    GltfJson json = document.section("cameras").get(node.camera().getAsInt());
    return new ModelCamera(
        node.name().isEmpty() ? json.text("name", "") : node.name(),
        node.location() + ".camera",
        lens(json),
        toWorld);
  }

  private ModelCamera.Lens lens(GltfJson camera) throws ModelFormatException {
    String type = camera.choice("type", "", List.of("perspective", "orthographic"));
    GltfJson json = camera.requireObject(type);
    if (type.equals("orthographic")) {
      return new ModelCamera.Parallel(half(json, "xmag"), half(json, "ymag"));
    }
    double fov = json.requirePositive("yfov");
    if (!(fov < Math.PI)) {
      throw json.expected("yfov", "less than pi");
    }
    return new ModelCamera.Perspective(
        fov,
        json.has("aspectRatio")
            ? OptionalDouble.of(json.requirePositive("aspectRatio"))
            : OptionalDouble.empty());
  }

  private double half(GltfJson json, String member) throws ModelFormatException {
    double size = json.number(member, 0);
    if (size == 0) {
      throw json.expected(member, "a number > 0");
    }
    if (size < 0) {
      document.warnings().add(json.location(member), "negative; its absolute value is used");
    }
    return Math.abs(size);
  }
}
