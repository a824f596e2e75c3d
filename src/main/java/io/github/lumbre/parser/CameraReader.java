package io.github.lumbre.parser;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.parser.ObjectTree.Placed;
import java.util.Optional;
import java.util.function.Function;

/** Reads the main camera of a scene. */
final class CameraReader {
  static final String DEFAULT_TYPE = "Pinhole";

  private final TextureReader textures;

  /** The camera types and their keys. */
  final Family<Function<JsonNode, Lens>> family =
      new Family<Function<JsonNode, Lens>>("cameraType", ObjectTree.COMMON_KEYS)
          .with(DEFAULT_TYPE, CameraReader::pinhole, "fieldOfView")
          .with(
              "ThinLens",
              this::thinLens,
              "fieldOfView",
              "focusDistance",
              "aperture",
              "bokehTextureId")
          .with("Orthographic", CameraReader::orthographic, "height")
          .with("Cylindrical", CameraReader::cylindrical, "height")
          .with("Spherical", camera -> Lens.spherical())
          .with("FishEye", CameraReader::fishEye, "angle");

  CameraReader(TextureReader textures) {
    this.textures = textures;
  }

  /** Warns of keys that no camera type has. */
  void check(Placed camera) {
    camera.node().warnUnknown(family.keys());
  }

  /**
   * Returns the camera; empty, with an error added, if its type is unknown.
   *
   * @param aspect width of the film over its height
   */
  Optional<Camera> read(Placed camera, double aspect) {
    return family
        .choose(camera.node(), DEFAULT_TYPE)
        .map(reader -> reader.apply(camera.node()))
        .map(lens -> lens.camera(camera.position(), camera.axes(), aspect));
  }

  private static Lens pinhole(JsonNode camera) {
    return Lens.pinhole(fieldOfView(camera));
  }

  private Lens thinLens(JsonNode camera) {
    return new Lens.ThinLens(
        fieldOfView(camera),
        camera.number("focusDistance", 5, LensRanges.FOCUS_DISTANCE),
        camera.number("aperture", .2, Range.NOT_NEGATIVE),
        textures.mask(camera, "bokehTextureId").orElse(Aperture.DISK));
  }

  private static Lens orthographic(JsonNode camera) {
    return Lens.orthographic(camera.number("height", 2, Range.POSITIVE));
  }

  private static Lens cylindrical(JsonNode camera) {
    return Lens.cylindrical(camera.number("height", 2, LensRanges.CYLINDER_HEIGHT));
  }

  private static Lens fishEye(JsonNode camera) {
    return Lens.fishEye(camera.number("angle", 180, LensRanges.FISH_EYE_ANGLE));
  }

  private static double fieldOfView(JsonNode camera) {
    return camera.number("fieldOfView", 60, LensRanges.FIELD_OF_VIEW);
  }
}
