package io.github.lumbre.cli.mcp;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.Optional;

/**
 * What the center of a pixel shows: the nearest surface, also if it is transparent.
 *
 * @param part the name of a part of the model, or of another object
 * @param material its name; empty if it has none
 * @param position in the space of the model's bounds; in world space for scenes
 * @param normal in the same space, a unit vector towards the camera's side
 * @param depth the distance from the camera along its direction
 */
record PixelPoint(String part, String material, Vec3 position, Vec3 normal, double depth) {
  /**
   * Returns what is seen; empty if it is no surface.
   *
   * @param x column in the full frame
   * @param y row in the full frame
   */
  static Optional<PixelPoint> of(Shot shot, int x, int y) {
    RenderSettings settings = shot.file().settings();
    Scene scene = shot.file().scene().framed(settings.aspect());
    CameraRay aimed = new CameraRay();
    double u = (x + .5) / settings.width();
    double v = (y + .5) / settings.height();
    if (!scene.camera().aim(u, v, new SobolSampler(0), aimed)) {
      return Optional.empty();
    }
    Ray ray = aimed.toRay();
    NearestHit hit = new NearestHit();
    scene.intersect(ray, hit);
    return hit.isHit() ? Optional.of(of(shot, scene, ray, hit)) : Optional.empty();
  }

  private static PixelPoint of(Shot shot, Scene scene, Ray ray, NearestHit hit) {
    Vec3 point = ray.origin().plus(hit.t(), ray.direction());
    double depth = point.minus(scene.camera().position()).dot(scene.camera().axes().normal());
    SurfaceHit surface = scene.surfaceAt(hit);
    Vec3 normal = surface.shadingNormal();
    Vec3 facing = normal.dot(ray.direction()) > 0 ? normal.times(-1) : normal;
    Transform shown = shot.isModel() ? ModelScene.TO_LEFT_HANDED : Transform.IDENTITY;
    SceneOrigins origins = shot.file().parsed().origins();
    int part = shot.parts().at(hit);
    return new PixelPoint(
        part == PartTable.NONE
            ? text(origins.primitives().get(hit.shape()))
            : shot.parts().parts().get(part).name(),
        text(origins.materials().get(hit.shape())),
        shown.point(point),
        shown.vector(facing),
        depth);
  }

  private static String text(Origin origin) {
    return origin.name().isEmpty() ? origin.path() : origin.name();
  }
}
