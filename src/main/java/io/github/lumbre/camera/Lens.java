package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * What kind of camera it is, without its place and the aspect ratio of the film. Immutable.
 *
 * <p>Each record checks its numbers as the camera that it makes does, and throws {@link
 * IllegalArgumentException}.
 */
public sealed interface Lens {
  /**
   * Returns a camera with this lens.
   *
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   */
  Camera camera(Vec3 position, Frame axes, double aspect);

  /**
   * A perspective camera without a lens: everything is in focus.
   *
   * @param fovDegrees the full vertical angle of view, in degrees, in (0, 180)
   */
  record Pinhole(double fovDegrees) implements Lens {
    public Pinhole {
      PinholeCamera.halfHeight(fovDegrees);
    }

    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new PinholeCamera(position, axes, aspect, fovDegrees);
    }
  }

  /**
   * A perspective camera with a thin lens, which blurs everything out of focus.
   *
   * @param fovDegrees the full vertical angle of view, in degrees, in (0, 180)
   * @param focusDistance from the lens to the plane of focus, in world units, &gt; 0
   * @param apertureSize in world units, ≥ 0: the radius of a disk, the width of a mask
   * @param aperture the shape: {@link Aperture#DISK} or {@link Aperture#mask}
   */
  record ThinLens(double fovDegrees, double focusDistance, double apertureSize, Aperture aperture)
      implements Lens {
    public ThinLens {
      Objects.requireNonNull(aperture, "aperture");
      new ThinLensCamera(
          Vec3.ZERO, Frame.WORLD, 1, fovDegrees, focusDistance, apertureSize, aperture);
    }

    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new ThinLensCamera(
          position, axes, aspect, fovDegrees, focusDistance, apertureSize, aperture);
    }

    /** Returns this lens with the another shape, such as {@link Aperture#mask}. */
    public ThinLens shaped(Aperture shape) {
      return new ThinLens(fovDegrees, focusDistance, apertureSize, shape);
    }
  }

  /**
   * Parallel projection.
   *
   * @param height of the film, in world units, &gt; 0 and finite
   */
  record Orthographic(double height) implements Lens {
    public Orthographic {
      new OrthographicCamera(Vec3.ZERO, Frame.WORLD, 1, height);
    }

    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new OrthographicCamera(position, axes, aspect, height);
    }
  }

  /**
   * A 360° panorama on an upright cylinder.
   *
   * @param halfHeight half the height of the film on the unit cylinder, in [0, 1e150]
   */
  record Cylindrical(double halfHeight) implements Lens {
    public Cylindrical {
      new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 1, halfHeight);
    }

    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new CylindricalCamera(position, axes, aspect, halfHeight);
    }
  }

  /** A full panorama of 360° by 180°. */
  record Spherical() implements Lens {
    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new SphericalCamera(position, axes, aspect);
    }
  }

  /**
   * A fisheye with equidistant projection.
   *
   * @param angleDegrees the full angle of view across the circle, in degrees, in (0, 360]
   */
  record FishEye(double angleDegrees) implements Lens {
    public FishEye {
      new FishEyeCamera(Vec3.ZERO, Frame.WORLD, 1, angleDegrees);
    }

    @Override
    public Camera camera(Vec3 position, Frame axes, double aspect) {
      return new FishEyeCamera(position, axes, aspect, angleDegrees);
    }
  }

  /** Returns a lens without blur; see {@link Pinhole}. */
  static Pinhole pinhole(double fovDegrees) {
    return new Pinhole(fovDegrees);
  }

  /** Returns a lens with a round aperture; see {@link ThinLens}. */
  static ThinLens thinLens(double fovDegrees, double focusDistance, double apertureRadius) {
    return new ThinLens(fovDegrees, focusDistance, apertureRadius, Aperture.DISK);
  }

  /** Returns a parallel projection; see {@link Orthographic}. */
  static Orthographic orthographic(double height) {
    return new Orthographic(height);
  }

  /** Returns a cylindrical panorama; see {@link Cylindrical}. */
  static Cylindrical cylindrical(double halfHeight) {
    return new Cylindrical(halfHeight);
  }

  /** Returns a spherical panorama. */
  static Spherical spherical() {
    return new Spherical();
  }

  /** Returns a fisheye; see {@link FishEye}. */
  static FishEye fishEye(double angleDegrees) {
    return new FishEye(angleDegrees);
  }
}
