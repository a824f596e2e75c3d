package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex.End;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Meeting;
import io.github.lumbre.integrator.PathVertex.Scattering;
import io.github.lumbre.integrator.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Mis;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A path tracer that remembers the last path, vertex by vertex. Mutable. */
public final class PathRecorder extends PathTracer implements Recorder {
  private final int maxDepth;
  private final int firstRoulette;
  private final List<PathVertex> vertices = new ArrayList<>();
  private final List<Gathered> gathered = new ArrayList<>();
  private Optional<Scattering> scattering = Optional.empty();
  private Rgb throughput = Rgb.WHITE;
  private Rgb arrived = Rgb.BLACK;

  /** What the path met where it scattered: the search for the next meeting forgets it. */
  private int scatteringShape;

  private boolean lostRoulette;
  private double lightPdf;
  private double weight;

  /** Makes one that computes what the path tracer of these options does. */
  public PathRecorder(Scene scene, PathOptions options) {
    super(scene, options);
    maxDepth = options.maxDepth();
    firstRoulette = options.firstRoulette();
  }

  @Override
  public List<PathVertex> vertices() {
    return List.copyOf(vertices);
  }

  @Override
  Rgb follow(Sampler sampler, Scratch scratch) {
    vertices.clear();
    return super.follow(sampler, scratch);
  }

  @Override
  boolean extend(int depth, Sampler sampler, Scratch scratch) {
    Ray ray = new Ray(scratch.hit.origin(), scratch.hit.direction());
    double pdf = scratch.path.pdf();
    throughput = scratch.path.weight();
    gathered.clear();
    scattering = Optional.empty();
    lostRoulette = false;
    lightPdf = 0;
    boolean wasSplit = scratch.path.isSplit();
    boolean scattersOn = super.extend(depth, sampler, scratch);
    // Where it is split, it goes on afterwards.
    boolean goesOn = scattersOn || scratch.path.isSplit() && !wasSplit;
    int shape = scattersOn ? scatteringShape : scratch.hit.shape();
    End end = goesOn ? End.GOES_ON : end(depth, scratch);
    Optional<Meeting> meeting = Optional.empty();
    if (end != End.ESCAPED) {
      boolean scatters = end != End.EMITTER && end != End.DEPTH;
      SurfaceHit surface = scatters ? scratch.vertex.surface() : scene.surfaceAt(scratch.hit);
      String bsdf = scatters ? scratch.vertex.bsdf().getClass().getSimpleName() : "";
      meeting = Optional.of(Recorder.meeting(shape, surface, bsdf));
      if (end == End.EMITTER) {
        gathered.add(emission(scratch, surface, pdf));
      }
    }
    vertices.add(
        new PathVertex(
            ray, throughput, meeting, gathered, scattering, end, scratch.path.radiance()));
    return scattersOn;
  }

  private End end(int depth, Scratch scratch) {
    if (!scratch.hit.isHit()) {
      return End.ESCAPED;
    }
    if (scene.primitiveAt(scratch.hit).emission().isPresent()) {
      return End.EMITTER;
    }
    if (depth == maxDepth) {
      return End.DEPTH;
    }
    return lostRoulette ? End.ROULETTE : End.ABSORBED;
  }

  private Gathered emission(Scratch scratch, SurfaceHit surface, double pdf) {
    Rgb radiance = emitted(scene.primitiveAt(scratch.hit).emission().get(), surface);
    return new Gathered(
        Source.EMISSION,
        scene.emitterAt(scratch.hit),
        surface.wo().negated(),
        radiance,
        Rgb.WHITE,
        lightPdf,
        pdf,
        weight,
        false,
        throughput.times(radiance.times(weight)));
  }

  @Override
  double emissionWeight(int emitter, Scratch scratch, SurfaceHit surface) {
    weight = super.emissionWeight(emitter, scratch, surface);
    return weight;
  }

  @Override
  double lightPdf(int emitter, Scratch scratch, double pdfOfEmitter) {
    lightPdf = super.lightPdf(emitter, scratch, pdfOfEmitter);
    return lightPdf;
  }

  @Override
  Rgb escaped(Scratch scratch, Vec3 direction) {
    Rgb light = super.escaped(scratch, direction);
    double pdf = scratch.path.pdf();
    if (!light.isBlack()) {
      // Of several domes, each has a weight of its own: told is their sum.
      boolean isWeighed = lightPdf > 0 && scene.environments().size() == 1;
      double bsdfWeight = isWeighed ? Mis.power(pdf, lightPdf) : 1;
      gathered.add(
          new Gathered(
              Source.BACKGROUND,
              scene.environments().size() == 1
                  ? scene.emitters().indexOf(scene.environments().get(0))
                  : -1,
              direction,
              isWeighed ? scene.background(direction) : light,
              Rgb.WHITE,
              isWeighed ? lightPdf : 0,
              pdf,
              bsdfWeight,
              false,
              throughput.times(light)));
    }
    return light;
  }

  @Override
  Rgb ambient(Vertex vertex) {
    Rgb light = super.ambient(vertex);
    gathered.add(Recorder.ambient(scene.ambient(), light, throughput));
    return light;
  }

  @Override
  void direct(Vertex vertex, Sampler sampler, int dimension, Scratch scratch) {
    long shadowRays = scratch.shadowRays();
    arrived = Rgb.BLACK;
    super.direct(vertex, sampler, dimension, scratch);
    LightSample light = scratch.light;
    if (!light.isEmpty()) {
      double pdf = scratch.choice.probability() * (light.isDelta() ? 1 : light.pdf());
      gathered.add(
          new Gathered(
              Source.LIGHT,
              scratch.choice.emitter(),
              light.wi(),
              light.radiance(),
              scratch.value.f(),
              pdf,
              scratch.value.pdf(),
              light.isDelta() ? 1 : Mis.power(pdf, scratch.value.pdf()),
              scratch.shadowRays() > shadowRays && arrived.isBlack(),
              throughput.times(arrived)));
    }
  }

  @Override
  void arrive(Path path, double r, double g, double b) {
    arrived = new Rgb(r, g, b);
    super.arrive(path, r, g, b);
  }

  @Override
  boolean scatter(Vertex vertex, int depth, double u, double v, Sampler sampler, Scratch scratch) {
    scatteringShape = scratch.hit.shape();
    boolean goesOn = super.scatter(vertex, depth, u, v, sampler, scratch);
    BsdfSample drawn = scratch.scattered;
    if (!drawn.isAbsorbed()) {
      double survival =
          depth < firstRoulette
              ? 1
              : Math.min(1, throughput.times(drawn.weight()).max() * scratch.path.ways());
      scattering = Optional.of(new Scattering(drawn.wi(), drawn.weight(), drawn.pdf(), survival));
      lostRoulette = !goesOn;
    }
    return goesOn;
  }
}
