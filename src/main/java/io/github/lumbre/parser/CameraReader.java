package io.github.lumbre.parser;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.parser.ObjectTree.Placed;
import java.util.Optional;

/** Reads the main camera of a scene. */
final class CameraReader {
  static final String DEFAULT_TYPE = "Pinhole";

  private static final Range FIELD_OF_VIEW = Range.open(0, 180);
  private static final Range CYLINDER_HEIGHT = Range.closed(0, 1e150);
  private static final Range FISH_EYE_ANGLE = Range.above(0, 360);

  /** Reads a camera of one type. */
  private interface Reader {
    Camera read(Placed camera, double aspect);
  }

  private final TextureReader textures;
  private final Family<Reader> family =
      new Family<Reader>("cameraType", ObjectTree.COMMON_KEYS)
          .with(DEFAULT_TYPE, this::pinhole, "fieldOfView")
          .with(
              "ThinLens",
              this::thinLens,
              "fieldOfView",
              "focusDistance",
              "aperture",
              "bokehTextureId")
          .with("Orthographic", this::orthographic, "height")
          .with("Cylindrical", this::cylindrical, "height")
          .with("Spherical", this::spherical)
          .with("FishEye", this::fishEye, "angle");

  CameraReader(TextureReader textures) {
    this.textures = textures;
  }

  /** Returns the camera types and their keys. */
  Family<?> family() {
    return family;
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
    return family.choose(camera.node(), DEFAULT_TYPE).map(reader -> reader.read(camera, aspect));
  }

  private Camera pinhole(Placed camera, double aspect) {
    return Lens.pinhole(fieldOfView(camera)).camera(camera.position(), camera.axes(), aspect);
  }

  private Camera thinLens(Placed camera, double aspect) {
    return new ThinLensCamera(
        camera.position(),
        camera.axes(),
        aspect,
        fieldOfView(camera),
        camera.node().number("focusDistance", 5, Range.POSITIVE),
        camera.node().number("aperture", .2, Range.NOT_NEGATIVE),
        textures.mask(camera.node(), "bokehTextureId").orElse(Aperture.DISK));
  }

  private Camera orthographic(Placed camera, double aspect) {
    double height = camera.node().number("height", 2, Range.POSITIVE);
    return Lens.orthographic(height).camera(camera.position(), camera.axes(), aspect);
  }

  private Camera cylindrical(Placed camera, double aspect) {
    double height = camera.node().number("height", 2, CYLINDER_HEIGHT);
    return Lens.cylindrical(height).camera(camera.position(), camera.axes(), aspect);
  }

  private Camera spherical(Placed camera, double aspect) {
    return Lens.spherical().camera(camera.position(), camera.axes(), aspect);
  }

  private Camera fishEye(Placed camera, double aspect) {
    double angle = camera.node().number("angle", 180, FISH_EYE_ANGLE);
    return Lens.fishEye(angle).camera(camera.position(), camera.axes(), aspect);
  }

  private static double fieldOfView(Placed camera) {
    return camera.node().number("fieldOfView", 60, FIELD_OF_VIEW);
  }
}
