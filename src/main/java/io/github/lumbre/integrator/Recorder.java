package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Meeting;
import io.github.lumbre.integrator.PathVertex.Source;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * An integrator that remembers the last path it followed, and computes the same bits as the one
 * that does not. Mutable, and confined to one thread.
 */
public sealed interface Recorder extends Integrator permits PathRecorder, RayRecorder {
  /** Returns the vertices of the last path, in the order in which they were found. */
  List<PathVertex> vertices();

  /** Describes what was met. */
  static Meeting meeting(int primitive, SurfaceHit surface, String bsdf) {
    return new Meeting(
        primitive, surface.position(), surface.geometricNormal(), surface.shadingNormal(), bsdf);
  }

  /** Describes light from nowhere in particular. */
  static Gathered ambient(Rgb irradiance, Rgb light, Rgb throughput) {
    Rgb radiance = irradiance.times(Elementary.INV_PI);
    return new Gathered(
        Source.AMBIENT,
        -1,
        Vec3.ZERO,
        radiance,
        Rgb.WHITE,
        0,
        0,
        1,
        false,
        throughput.times(light));
  }
}
