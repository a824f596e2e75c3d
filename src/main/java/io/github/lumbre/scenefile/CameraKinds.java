package io.github.lumbre.scenefile;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.Lens.Cylindrical;
import io.github.lumbre.camera.Lens.FishEye;
import io.github.lumbre.camera.Lens.Orthographic;
import io.github.lumbre.camera.Lens.Pinhole;
import io.github.lumbre.camera.Lens.Spherical;
import io.github.lumbre.camera.Lens.ThinLens;
import io.github.lumbre.camera.internal.BokehCache;
import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.scenefile.internal.CameraKeys;
import java.util.Optional;
import java.util.function.BiFunction;

/** The cameras of scene files. */
final class CameraKinds {
  static final Family<BiFunction<JsonNode, TextureReader, Lens>> FAMILY =
      new Family<>("cameraType", Optional.of("Pinhole"), "a lens", ObjectKeys.ALL);

  private static final Key<Double> FIELD_OF_VIEW =
      Key.number(
          CameraKeys.FIELD_OF_VIEW,
          LensRanges.FIELD_OF_VIEW,
          60,
          "Full vertical angle, in degrees.");

  static {
    FAMILY
        .kind("Pinhole", Pinhole.class, (node, textures) -> Lens.pinhole(FIELD_OF_VIEW.in(node)))
        .with(FIELD_OF_VIEW, Pinhole::fovDegrees);
    thinLens();
    Key<Double> parallel =
        Key.number(CameraKeys.HEIGHT, Range.POSITIVE, 2, "Of the film, in scene units.");
    FAMILY
        .kind(
            "Orthographic",
            Orthographic.class,
            (node, textures) -> Lens.orthographic(parallel.in(node)))
        .with(parallel, Orthographic::height);
    Key<Double> cylinder =
        Key.number(
            "height", LensRanges.CYLINDER_HEIGHT, 2, "Half the height of a cylinder of radius 1.");
    FAMILY
        .kind(
            "Cylindrical",
            Cylindrical.class,
            (node, textures) -> Lens.cylindrical(cylinder.in(node)))
        .with(cylinder, Cylindrical::halfHeight);
    FAMILY.kind("Spherical", Spherical.class, (node, textures) -> Lens.spherical());
    Key<Double> angle =
        Key.number("angle", LensRanges.FISH_EYE_ANGLE, 180, "Across the circle, in degrees.");
    FAMILY
        .kind("FishEye", FishEye.class, (node, textures) -> Lens.fishEye(angle.in(node)))
        .with(angle, FishEye::angleDegrees);
  }

  private CameraKinds() {}

  private static void thinLens() {
    Key<Double> focus =
        Key.number(
            "focusDistance",
            LensRanges.FOCUS_DISTANCE,
            5,
            "From the lens to the plane of focus, in scene units.");
    Key<Double> aperture =
        Key.number(
            "aperture",
            Range.NOT_NEGATIVE,
            .2,
            "In scene units: the radius of the lens, or the width of its mask.");
    Key<Integer> mask = Key.id("bokehTextureId").omitted();
    FAMILY
        .kind(
            "ThinLens",
            ThinLens.class,
            (node, textures) ->
                new ThinLens(
                    FIELD_OF_VIEW.in(node),
                    focus.in(node),
                    aperture.in(node),
                    textures.mask(node, mask).orElse(Aperture.DISK)))
        .with(FIELD_OF_VIEW, ThinLens::fovDegrees)
        // Greater distances focus as the greatest number does, but scenes cannot state them.
        .with(focus, lens -> Math.min(lens.focusDistance(), Double.MAX_VALUE))
        .with(aperture, ThinLens::apertureSize)
        .with(mask, (lens, textures) -> mask(lens.aperture(), textures));
  }

  private static int mask(Aperture aperture, TextureWriter textures) {
    if (aperture instanceof BokehCache mask) {
      return textures.mask(mask);
    }
    if (aperture == Aperture.DISK) {
      return AssetTable.NONE;
    }
    throw new Unwritable("aperture: a disk or a mask", Unwritable.name(aperture));
  }

  /**
   * Returns the camera; empty, with an error added, if its kind is unknown.
   *
   * @param aspect width of the film over its height
   */
  static Optional<Camera> read(Placed camera, double aspect, TextureReader textures) {
    return FAMILY
        .choose(camera.node())
        .map(reader -> reader.apply(camera.node(), textures))
        .map(lens -> lens.camera(camera.position(), camera.axes(), aspect));
  }
}
