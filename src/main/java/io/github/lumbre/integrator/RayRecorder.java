package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex.End;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Meeting;
import io.github.lumbre.integrator.PathVertex.Source;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** A ray tracer that remembers the last tree of rays, branch by branch. Mutable. */
public final class RayRecorder extends RayTracer implements Recorder {
  private final List<PathVertex> vertices = new ArrayList<>();
  private final List<Gathered> gathered = new ArrayList<>();
  private final int[] emitterOfLight;
  private Rgb throughput = Rgb.WHITE;
  private Rgb sum = Rgb.BLACK;

  /**
   * @param maxReflections as of {@link RayTracer}
   * @param maxRefractions as of {@link RayTracer}
   */
  public RayRecorder(Scene scene, int maxReflections, int maxRefractions) {
    super(scene, maxReflections, maxRefractions);
    emitterOfLight = new int[lights.size()];
    int emitter = 0;
    for (int i = 0; i < emitterOfLight.length; i++) {
      // Lights stand among the emitters in the same order.
      Light light = lights.get(i);
      while (!scene.emitters().get(emitter).equals(light)) {
        emitter++;
      }
      emitterOfLight[i] = emitter++;
    }
  }

  @Override
  public List<PathVertex> vertices() {
    return List.copyOf(vertices);
  }

  @Override
  public Rgb radiance(Ray cameraRay, Sampler sampler, Scratch scratch) {
    vertices.clear();
    sum = Rgb.BLACK;
    return super.radiance(cameraRay, sampler, scratch);
  }

  @Override
  Rgb follow(Branch branch, int number, Sampler sampler, Scratch scratch, Deque<Branch> pending) {
    gathered.clear();
    throughput = branch.throughput();
    int waiting = pending.size();
    Rgb light = super.follow(branch, number, sampler, scratch, pending);
    sum = sum.plus(light);
    Optional<Meeting> meeting = Optional.empty();
    End end = pending.size() > waiting ? End.GOES_ON : End.DEPTH;
    if (scratch.hit.isHit()) {
      Primitive primitive = scene.primitiveAt(scratch.hit);
      boolean glows = primitive.emission().isPresent();
      SurfaceHit surface = glows ? scene.surfaceAt(scratch.hit) : scratch.vertex.surface();
      String bsdf = glows ? "" : scratch.vertex.bsdf().getClass().getSimpleName();
      meeting = Optional.of(Recorder.meeting(scratch.hit.shape(), surface, bsdf));
      if (glows) {
        end = End.EMITTER;
        gathered.add(seen(Source.EMISSION, scene.emitterAt(scratch.hit), branch.ray(), light));
      } else if (!scratch.vertex.bsdf().isSpecular() && end == End.DEPTH) {
        end = End.ABSORBED;
      }
    } else {
      end = End.ESCAPED;
      if (!light.isBlack()) {
        gathered.add(seen(Source.BACKGROUND, -1, branch.ray(), light));
      }
    }
    vertices.add(
        new PathVertex(
            branch.ray(), branch.throughput(), meeting, gathered, Optional.empty(), end, sum));
    return light;
  }

  private Gathered seen(Source source, int emitter, Ray ray, Rgb light) {
    Rgb radiance =
        new Rgb(
            ratio(light.r(), throughput.r()),
            ratio(light.g(), throughput.g()),
            ratio(light.b(), throughput.b()));
    return new Gathered(
        source,
        emitter,
        ray.direction(),
        radiance,
        Rgb.WHITE,
        0,
        Double.POSITIVE_INFINITY,
        1,
        false,
        light);
  }

  private static double ratio(double light, double share) {
    return share == 0 ? 0 : light / share;
  }

  @Override
  Rgb arriving(int number, LightSample light, Vertex vertex, Scratch scratch) {
    long shadowRays = scratch.shadowRays();
    Rgb scattered = super.arriving(number, light, vertex, scratch);
    boolean traced = scratch.shadowRays() > shadowRays;
    gathered.add(
        new Gathered(
            Source.LIGHT,
            emitterOfLight[number],
            light.wi(),
            light.radiance(),
            scratch.value.f(),
            light.isDelta() ? 1 : light.pdf(),
            0,
            1,
            traced && scattered.isBlack(),
            throughput.times(scattered)));
    return scattered;
  }
}
