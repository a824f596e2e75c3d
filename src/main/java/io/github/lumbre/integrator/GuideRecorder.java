package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.integrator.guiding.GuideRecords;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;

/**
 * Records the non-specular vertices of paths. Light that a ray hits has the weight of multiple
 * importance sampling that it would have without a guide: what light sampling finds needs none.
 * With the weight of the guided ray, a guide towards a lamp would make itself seem needed. Mutable
 * and confined to one thread. Paths must not be split.
 */
public final class GuideRecorder implements PathListener {
  /** Relative difference from the density of a diffuse surface that is due to rounding. */
  private static final double TOLERANCE = 1e-6;

  private static final MisHeuristic HEURISTIC = MisHeuristic.BOTH;

  private final GuideRecords records;

  /** The throughput of the last ray. */
  private double red, green, blue;

  /** Whether the path is at a vertex that it has not left. */
  private boolean isAtVertex;

  /** Whether there is a vertex that the path has left. */
  private boolean hasLeft;

  private double x, y, z;
  private double normalX, normalY, normalZ;
  private double throughput;
  private double direct;
  private double directionX, directionY, directionZ;
  private double diffuse;
  private double pdf;
  private double bsdfPdf;
  private double found;

  /** Creates a recorder that adds to a list. */
  public GuideRecorder(GuideRecords records) {
    this.records = records;
  }

  /** Ends the last path. */
  public void endPath() {
    if (isAtVertex) {
      addVertex();
    } else if (hasLeft) {
      leave(0, false);
    }
    isAtVertex = false;
    hasLeft = false;
  }

  @Override
  public void pathStarted() {
    endPath();
  }

  @Override
  public void rayTraced(NearestHit ray, int depth, double r, double g, double b) {
    red = r;
    green = g;
    blue = b;
  }

  @Override
  public void vertexReached(int primitive, SurfaceHit surface, Bsdf bsdf) {
    double here = red + green + blue;
    if (bsdf.isSpecular() || !(here > 0)) {
      return;
    }
    if (records.isFull()) {
      endPath();
      return;
    }
    if (hasLeft) {
      leave(here / throughput, true);
      hasLeft = false;
    }
    isAtVertex = true;
    throughput = here;
    direct = 0;
    diffuse = 0;
    Vec3 p = surface.position();
    Vec3 n = surface.shadingNormal();
    double side = n.dot(surface.wo()) < 0 ? -1 : 1;
    x = p.x();
    y = p.y();
    z = p.z();
    normalX = side * n.x();
    normalY = side * n.y();
    normalZ = side * n.z();
  }

  private void addVertex() {
    records.add(x, y, z, normalX, normalY, normalZ, direct, diffuse);
  }

  private void leave(double weight, boolean next) {
    records.leave(directionX, directionY, directionZ, pdf, bsdfPdf, found, weight, next);
  }

  @Override
  public void scattered(BsdfSample sample, double survival, boolean survives) {
    if (!isAtVertex) {
      return;
    }
    diffuse = diffuse(sample);
    addVertex();
    isAtVertex = false;
    hasLeft = survives;
    directionX = sample.x();
    directionY = sample.y();
    directionZ = sample.z();
    pdf = sample.isSpecular() ? 0 : sample.pdf();
    bsdfPdf = sample.isSpecular() ? 0 : sample.bsdfPdf();
    found = 0;
  }

  /** Returns what part of the light the surface scatters if it is diffuse, and 0 otherwise. */
  private double diffuse(BsdfSample sample) {
    double cosine = sample.x() * normalX + sample.y() * normalY + sample.z() * normalZ;
    double even = cosine / Math.PI;
    if (sample.isSpecular() || !(Math.abs(sample.bsdfPdf() - even) < TOLERANCE * even)) {
      return 0;
    }
    double scattered = red * sample.r() + green * sample.g() + blue * sample.b();
    return scattered / throughput * sample.pdf() / even;
  }

  @Override
  public void lightSampled(
      Source source,
      int emitter,
      LightSample light,
      BsdfValue value,
      double lightPdf,
      double misWeight,
      boolean blocked) {
    if (isAtVertex && !blocked) {
      double weight =
          light.isDelta() ? misWeight : HEURISTIC.lightWeight(lightPdf, value.bsdfPdf());
      double part = weight / lightPdf;
      direct +=
          scattered(
              part * value.r() * light.r(),
              part * value.g() * light.g(),
              part * value.b() * light.b());
    }
  }

  @Override
  public void lightFound(
      Source source,
      int emitter,
      double r,
      double g,
      double b,
      double lightPdf,
      double rayPdf,
      double misWeight) {
    if (isAtVertex) {
      direct += scattered(r, g, b);
    } else if (hasLeft) {
      double weight =
          lightPdf > 0 && pdf > 0 && rayPdf < Double.POSITIVE_INFINITY
              ? HEURISTIC.bsdfWeight(rayPdf * bsdfPdf / pdf, lightPdf)
              : misWeight;
      found += weight * scattered(r, g, b);
    }
  }

  /** Returns what part of some light reaches the viewer of the last vertex. */
  private double scattered(double r, double g, double b) {
    return (red * r + green * g + blue * b) / throughput;
  }

  @Override
  public void branchStarted(int branch) {
    throw new IllegalStateException("paths must not be split");
  }
}
