package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Hit;
import io.github.lumbre.integrator.path.PathVertex.Scattering;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Records the vertices of the last path that was traced with a {@link RenderContext}. Mutable and
 * confined to one thread.
 */
public final class PathRecorder implements PathListener {
  private final List<Step> steps = new ArrayList<>();
  private Step last = new Step(0, new Ray(Vec3.ZERO, Vec3.Z), Rgb.BLACK);

  /** The vertex where the path was split. */
  private Step split = last;

  private int branch;

  /** Whether the next direction is sampled at the split vertex. */
  private boolean isAtSplit;

  /** Creates a recorder that holds no path yet. */
  public PathRecorder() {}

  /** A vertex under construction. Mutable. */
  private static final class Step {
    final int branch;
    final Ray ray;
    final Rgb throughput;
    Optional<Hit> hit = Optional.empty();
    final List<FoundLight> pending = new ArrayList<>();
    final List<Contribution> contributions = new ArrayList<>();
    final List<Scattering> scattered = new ArrayList<>();
    End end = End.CONTINUES;

    Step(int branch, Ray ray, Rgb throughput) {
      this.branch = branch;
      this.ray = ray;
      this.throughput = throughput;
    }

    /** Adds the lights reported since the last call as one contribution. */
    void add(Rgb amount) {
      if (!pending.isEmpty() || !amount.isBlack()) {
        contributions.add(new Contribution(pending, amount));
        pending.clear();
      }
    }

    PathVertex vertex() {
      return new PathVertex(branch, ray, throughput, hit, contributions, scattered, end);
    }
  }

  /** Returns the vertices of the last path, in the order in which they were reached. */
  public List<PathVertex> vertices() {
    return steps.stream().map(Step::vertex).toList();
  }

  @Override
  public void pathStarted() {
    steps.clear();
    branch = 0;
    isAtSplit = false;
  }

  @Override
  public void rayTraced(NearestHit ray, int depth, double r, double g, double b) {
    last.add(Rgb.BLACK);
    last = new Step(branch, new Ray(ray.origin(), ray.direction()), new Rgb(r, g, b));
    steps.add(last);
    isAtSplit = false;
  }

  @Override
  public void surfaceHit(NearestHit ray, Scene scene) {
    last.hit = Optional.of(hit(ray.shape(), scene.surfaceAt(ray), ""));
  }

  @Override
  public void vertexReached(int primitive, SurfaceHit surface, Bsdf bsdf) {
    last.hit = Optional.of(hit(primitive, surface, bsdf.getClass().getSimpleName()));
  }

  private static Hit hit(int primitive, SurfaceHit surface, String bsdf) {
    return new Hit(
        primitive, surface.position(), surface.geometricNormal(), surface.shadingNormal(), bsdf);
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
    last.pending.add(
        new FoundLight(
            source,
            emitter,
            light.wi(),
            light.radiance(),
            value.f(),
            lightPdf,
            value.pdf(),
            misWeight,
            blocked));
  }

  @Override
  public void lightFound(
      Source source,
      int emitter,
      double r,
      double g,
      double b,
      double lightPdf,
      double bsdfPdf,
      double misWeight) {
    Vec3 wi = source == Source.AMBIENT ? Vec3.ZERO : last.ray.direction();
    Rgb radiance = new Rgb(r, g, b);
    last.pending.add(
        new FoundLight(
            source, emitter, wi, radiance, Rgb.WHITE, lightPdf, bsdfPdf, misWeight, false));
  }

  @Override
  public void lightAdded(double r, double g, double b) {
    last.add(last.throughput.times(new Rgb(r, g, b)));
  }

  @Override
  public void scattered(BsdfSample sample, double survival, boolean survives) {
    Step at = isAtSplit ? split : last;
    at.scattered.add(
        new Scattering(sample.wi(), sample.weight(), sample.pdf(), survival, survives));
    if (!survives && !isAtSplit) {
      last.add(Rgb.BLACK);
      last.end = End.ROULETTE;
    }
  }

  @Override
  public void branchStarted(int newBranch) {
    if (newBranch == 0) {
      split = last;
    }
    branch = newBranch;
    isAtSplit = true;
  }

  @Override
  public void pathEnded(End end) {
    last.add(Rgb.BLACK);
    if (!isAtSplit) {
      last.end = end;
    }
  }
}
