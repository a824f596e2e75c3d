package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Vec3;

/**
 * The last non-specular vertex of a path, and the specular surfaces that the path met since. Light
 * that the path then finds may also be found from that vertex, by way of those surfaces. Mutable;
 * each thread reuses one instance.
 */
final class SpecularLink {
  /** The density with which the path left the vertex; 0 if there is no vertex. */
  private double pdf;

  /** The path's throughput at the vertex, its largest component. */
  private double throughput;

  /** Plain numbers: most paths leave vertices without meeting a specular surface. */
  private double vertexX, vertexY, vertexZ;

  private double facingX, facingY, facingZ;

  /** The number of specular surfaces since the vertex. */
  private int surfaces;

  /** The first of them. */
  private int primitive;

  private boolean isFrontal;
  private Vec3 origin = Vec3.ZERO;
  private Vec3 direction = Vec3.ZERO;
  private Vec3 point = Vec3.ZERO;

  /** The probability with which all of them refract; 0 if one of them did not. */
  private double passProbability;

  /** Starts a path, which has no vertex yet. */
  void begin() {
    pdf = 0;
    surfaces = 0;
  }

  /**
   * Leaves a vertex.
   *
   * @param pathThroughput the path's throughput at the vertex, its largest component
   * @param hit the ray that reached the vertex
   * @param sample the direction in which the path leaves the vertex, in world space
   */
  void leave(Vertex left, double pathThroughput, NearestHit hit, BsdfSample sample) {
    SurfaceHit surface = left.surface();
    if (!sample.isSpecular()) {
      Vec3 position = surface.origin();
      vertexX = position.x();
      vertexY = position.y();
      vertexZ = position.z();
      Vec3 facing = left.facing();
      facingX = facing.x();
      facingY = facing.y();
      facingZ = facing.z();
      pdf = sample.pdf();
      throughput = pathThroughput;
      surfaces = 0;
      return;
    }
    if (surfaces == 0) {
      primitive = hit.shape();
      isFrontal = surface.isFrontal();
      origin = hit.origin();
      direction = hit.direction();
      point = surface.position();
      passProbability = 1;
    }
    surfaces++;
    Vec3 normal = surface.geometricNormal();
    boolean passes = sample.wi().dot(normal) * surface.wo().dot(normal) < 0;
    passProbability *=
        passes && left.bsdf() instanceof Dielectric glass ? glass.passProbability(left.wo()) : 0;
  }

  /** Returns whether the path met one specular surface since it left the vertex. */
  boolean isSingle() {
    return pdf > 0 && surfaces == 1;
  }

  /** Returns whether clear glass refracted the path, at least once, and nothing else since. */
  boolean isRefracted() {
    return pdf > 0 && surfaces > 0 && passProbability > 0;
  }

  /** Returns the number of specular surfaces that the path met since it left the vertex. */
  int surfaces() {
    return surfaces;
  }

  /** Returns the probability with which the path was refracted; 0 if it was not at each surface. */
  double passProbability() {
    return passProbability;
  }

  /** Returns the density, per solid angle, with which the path left the vertex. */
  double pdf() {
    return pdf;
  }

  /** Returns the path's throughput at the vertex, its largest component. */
  double throughput() {
    return throughput;
  }

  /** Returns the position of the vertex, in world space. */
  Vec3 vertex() {
    return new Vec3(vertexX, vertexY, vertexZ);
  }

  /** Returns {@link Vertex#facing} of the vertex. */
  Vec3 facing() {
    return new Vec3(facingX, facingY, facingZ);
  }

  /** Returns the number of the first specular surface's primitive. */
  int primitive() {
    return primitive;
  }

  /** Returns whether the path met the outside of the first specular surface. */
  boolean isFrontal() {
    return isFrontal;
  }

  /** Returns where the ray from the vertex started, in world space. */
  Vec3 origin() {
    return origin;
  }

  /** Returns the unit direction of the ray from the vertex, in world space. */
  Vec3 direction() {
    return direction;
  }

  /** Returns where the path met the first specular surface, in world space. */
  Vec3 point() {
    return point;
  }
}
