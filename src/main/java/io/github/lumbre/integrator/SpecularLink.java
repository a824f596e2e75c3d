package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Vec3;

/**
 * The last non-specular vertex of a path, and the specular surface that the path met since, if it
 * is only one. Light that the path then finds may also be found from that vertex, by way of that
 * surface. Mutable; each thread reuses one instance.
 */
final class SpecularLink {
  /** The density with which the path left the vertex; 0 if there is no vertex. */
  private double pdf;

  private Vec3 vertex = Vec3.ZERO;
  private Vec3 facing = Vec3.ZERO;

  /** The primitive of the specular surface; -1 if none or more than one was met. */
  private int primitive = -1;

  private boolean isFrontal;
  private boolean isRefracted;
  private double cosine;
  private Vec3 origin = Vec3.ZERO;
  private Vec3 point = Vec3.ZERO;

  /** Starts a path, which has no vertex yet. */
  void begin() {
    pdf = 0;
    primitive = -1;
  }

  /**
   * Leaves a vertex.
   *
   * @param hit the ray that reached the vertex
   * @param sample the direction in which the path leaves the vertex, in world space
   */
  void leave(Vertex left, NearestHit hit, BsdfSample sample) {
    SurfaceHit surface = left.surface();
    if (!sample.isSpecular()) {
      vertex = surface.position();
      facing = left.facing();
      pdf = sample.pdf();
      primitive = -1;
    } else if (pdf > 0 && primitive < 0) {
      Vec3 normal = surface.geometricNormal();
      primitive = hit.shape();
      isFrontal = surface.isFrontal();
      isRefracted = sample.wi().dot(normal) * surface.wo().dot(normal) < 0;
      cosine = left.wo().z();
      origin = hit.origin();
      point = surface.position();
    } else {
      begin();
    }
  }

  /** Returns whether the path met one specular surface since it left the vertex. */
  boolean isSingle() {
    return primitive >= 0;
  }

  /** Returns the density, per solid angle, with which the path left the vertex. */
  double pdf() {
    return pdf;
  }

  /** Returns the position of the vertex, in world space. */
  Vec3 vertex() {
    return vertex;
  }

  /** Returns {@link Vertex#facing} of the vertex. */
  Vec3 facing() {
    return facing;
  }

  /** Returns the number of the specular surface's primitive. */
  int primitive() {
    return primitive;
  }

  /** Returns whether the path met the outside of the specular surface. */
  boolean isFrontal() {
    return isFrontal;
  }

  /** Returns whether the path went through the specular surface. */
  boolean isRefracted() {
    return isRefracted;
  }

  /** Returns the cosine at the specular surface towards the vertex, in its shading frame. */
  double cosine() {
    return cosine;
  }

  /** Returns where the ray from the vertex started, in world space. */
  Vec3 origin() {
    return origin;
  }

  /** Returns where the path met the specular surface, in world space. */
  Vec3 point() {
    return point;
  }
}
