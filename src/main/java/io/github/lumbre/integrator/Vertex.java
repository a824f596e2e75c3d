package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;

/**
 * A point where a path hits a surface: evaluates and samples the surface's BSDF in world space.
 * Mutable: each thread reuses one instance for all vertices.
 *
 * <p>With interpolated or perturbed normals, a direction may lie on one side of the shading plane
 * but on the other side of the surface. Such directions scatter no light, so that light never leaks
 * through a surface. The geometric normal decides on the side of the surface; after {@link #lift},
 * the interpolated normal does.
 */
final class Vertex {
  private SurfaceHit surface;
  private Bsdf bsdf;

  /** Where a guide has learned directions; {@link Guide#NO_CELL} if it has none. */
  private int cell = Guide.NO_CELL;

  /** Unit direction back along the path, in the local shading frame. */
  private double outX, outY, outZ;

  /** The unit normal that decides on which side of the surface a direction lies. */
  private double sideX, sideY, sideZ;

  /** The cosine of that direction and this normal. */
  private double outCosine;

  /**
   * Moves to another hit. May change the hit's shading frame, by a normal map or back to the
   * geometric normal.
   */
  void moveTo(SurfaceHit newSurface, Material material) {
    surface = newSurface;
    material.perturb(surface);
    // If the viewer is behind the shading plane but in front of the surface, shade with the
    // geometric normal.
    lookBack();
    decideBy(surface.geometricNormal());
    if (outCosine * outZ <= 0) {
      surface.shadeFlat();
      lookBack();
    }
    bsdf = material.at(surface);
  }

  /** Returns whether some surface of a scene disperses light, so that {@link #narrow} is needed. */
  static boolean mayDisperse(Scene scene) {
    return scene.primitives().stream().anyMatch(p -> p.material().isDispersive());
  }

  /**
   * Samples for the colors that the path carries.
   *
   * @param throughput of the path at this vertex
   */
  void narrow(Rgb throughput) {
    bsdf = bsdf.narrowed(throughput);
  }

  /**
   * Returns whether rays may leave from the smooth surface that vertex normals imply. They may not
   * if the surface transmits light, or if the viewer sees its front but the smooth surface's back.
   */
  boolean isLiftable() {
    return surface.hasLift()
        && !bsdf.transmits()
        && surface.wo().dot(surface.smoothNormal()) * outCosine > 0;
  }

  /**
   * Lets rays leave from near the smooth surface, whose normal decides from now on whether they are
   * reflected; requires {@link #isLiftable}.
   *
   * @param part of the way there, in [0,1]
   */
  void lift(double part) {
    surface.lift(part);
    decideBy(surface.smoothNormal());
  }

  private void decideBy(Vec3 normal) {
    sideX = normal.x();
    sideY = normal.y();
    sideZ = normal.z();
    outCosine = surface.wo().dot(normal);
  }

  private void lookBack() {
    Vec3 wo = surface.toLocal(surface.wo());
    outX = wo.x();
    outY = wo.y();
    outZ = wo.z();
  }

  SurfaceHit surface() {
    return surface;
  }

  Bsdf bsdf() {
    return bsdf;
  }

  /** Returns the unit direction back along the path, in the local shading frame. */
  Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /** Returns the world direction of a direction in the local shading frame. */
  Vec3 toWorld(Vec3 local) {
    return surface.toWorld(local);
  }

  /**
   * Moves the light sampler's receiver to this vertex. It receives light from the viewer's side of
   * the surface, or from both sides if the surface transmits light.
   */
  void receiveFrom(LightChoice choice) {
    choice.moveTo(surface.origin(), facing());
  }

  /**
   * Returns the unit shading normal of the side that receives light, in world space; zero if both
   * sides do.
   */
  Vec3 facing() {
    double side = bsdf.isTransmissive() ? 0 : Math.copySign(1, outZ);
    return surface.shadingNormal().times(side);
  }

  /** Looks up the place of this vertex in a guide. A specular vertex has none. */
  void findIn(Guide guide) {
    if (bsdf.isSpecular()) {
      cell = Guide.NO_CELL;
      return;
    }
    Vec3 p = surface.position();
    Vec3 n = surface.shadingNormal();
    double side = Math.copySign(1, outZ);
    cell = guide.cell(p.x(), p.y(), p.z(), side * n.x(), side * n.y(), side * n.z());
  }

  /** Returns the place of this vertex in the guide; {@link Guide#NO_CELL} if it has none. */
  int cell() {
    return cell;
  }

  /** Returns whether a guide has learned directions for this vertex. */
  boolean isGuided() {
    return cell != Guide.NO_CELL;
  }

  /** Computes f·|cos θi| and the density of BSDF sampling for the direction of a light sample. */
  void evaluate(LightSample light, BsdfValue value) {
    evaluate(light.wi(), value);
  }

  /**
   * Computes f·|cos θi| and the density of BSDF sampling.
   *
   * @param wi unit direction in world space
   */
  void evaluate(Vec3 wi, BsdfValue value) {
    Vec3 local = surface.toLocal(wi);
    if (isConsistent(wi.x(), wi.y(), wi.z(), local.z())) {
      bsdf.evaluate(outX, outY, outZ, local.x(), local.y(), local.z(), value);
    } else {
      value.clear();
    }
  }

  /** Samples the BSDF; the sampled direction is in world space. */
  void sample(double uLobe, double u, double v, BsdfSample drawn) {
    bsdf.sample(outX, outY, outZ, uLobe, u, v, drawn);
    if (drawn.isAbsorbed()) {
      return;
    }
    double x = drawn.x();
    double y = drawn.y();
    double z = drawn.z();
    double wx = surface.worldX(x, y, z);
    double wy = surface.worldY(x, y, z);
    double wz = surface.worldZ(x, y, z);
    if (isConsistent(wx, wy, wz, z)) {
      drawn.setDirection(wx, wy, wz);
    } else {
      drawn.absorb();
    }
  }

  /**
   * Returns the unit direction, in world space, that the surface refracts the path to; zero if it
   * reflects all light, or if the shading plane and the surface disagree on the direction's side.
   *
   * @param glass the surface's BSDF
   */
  Vec3 refracted(Dielectric glass) {
    Vec3 wo = wo();
    if (!(glass.reflected(wo) < 1)) {
      return Vec3.ZERO;
    }
    Vec3 local = glass.refract(wo);
    Vec3 wi = surface.toWorld(local);
    return isConsistent(wi.x(), wi.y(), wi.z(), local.z()) ? wi : Vec3.ZERO;
  }

  /**
   * Returns whether the shading plane and the surface agree on which side of the surface a world
   * direction lies.
   *
   * @param localZ the direction's z in the local shading frame
   */
  private boolean isConsistent(double wx, double wy, double wz, double localZ) {
    double cosine = wx * sideX + wy * sideY + wz * sideZ;
    return cosine * (localZ * outZ) * outCosine > 0;
  }
}
