package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.light.LightChoice;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Vec3;

/**
 * A point where a path hits a surface: the surface's Bsdf in world directions. Mutable: each thread
 * moves one and the same from vertex to vertex.
 *
 * <p>Interpolated and bent normals may put a direction on one side of the shading plane and on the
 * other of the true surface. Light never passes that way: such directions scatter nothing.
 */
final class Vertex {
  private SurfaceHit surface;
  private Bsdf bsdf;

  /** Direction back along the path, in the local frame. */
  private double outX, outY, outZ;

  /** Moves to another point; may turn the hit's shading frame. */
  void moveTo(SurfaceHit newSurface, Material material) {
    surface = newSurface;
    material.bend(surface);
    // A viewer behind the perturbed plane but in front of the true one sees the true one.
    lookBack();
    if (surface.wo().dot(surface.geometricNormal()) * outZ <= 0) {
      surface.shadeFlat();
      lookBack();
    }
    bsdf = material.at(surface);
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

  /** Returns the direction back along the path, in the local frame. */
  Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /** Returns the world direction of a local one. */
  Vec3 toWorld(Vec3 local) {
    return surface.toWorld(local);
  }

  /** Selects lights for this vertex: from the side or sides whose light scatters to the viewer. */
  void receiveFrom(LightChoice choice) {
    double side = bsdf.isTransmissive() ? 0 : Math.copySign(1, outZ);
    choice.moveTo(surface.position(), surface.shadingNormal().times(side));
  }

  /** Sets f·|cos θi| and the density of the unit world direction that light comes from. */
  void evaluate(LightSample light, BsdfValue value) {
    Vec3 wi = light.wi();
    Vec3 local = surface.toLocal(wi);
    if (isConsistent(wi.x(), wi.y(), wi.z(), local.z())) {
      bsdf.evaluate(outX, outY, outZ, local.x(), local.y(), local.z(), value);
    } else {
      value.clear();
    }
  }

  /** Draws a direction; the sample's wi is in world space. */
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

  /** Returns whether a world direction, with the given local z, is on a consistent side. */
  private boolean isConsistent(double wx, double wy, double wz, double localZ) {
    Vec3 normal = surface.geometricNormal();
    double cosine = wx * normal.x() + wy * normal.y() + wz * normal.z();
    return cosine * (localZ * outZ) * surface.wo().dot(normal) > 0;
  }
}
