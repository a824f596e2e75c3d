package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Dielectric;
import io.github.lumbre.material.RoughDielectric;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.Deque;
import java.util.List;
import java.util.Objects;

/**
 * Whitted's ray tracing (1980): light straight from every light, mirrors, and glass; no light from
 * one diffuse or glossy surface to another. Each area light and dome is sampled once.
 *
 * <p>What a step does is left open for {@link RayRecorder} to listen to; a program that records
 * nothing never loads that class, and the compiler takes the steps for final.
 */
public sealed class RayTracer implements Integrator permits RayRecorder {
  /**
   * Up to so many glass surfaces a path splits into what is reflected and what passes; from then on
   * it takes one of the two at random, so that deep glass does not cost 2^depth rays.
   */
  private static final int MAX_SPLITS = 4;

  /** For lobes that draw nothing. */
  private static final Point2 MIDDLE = new Point2(.5, .5);

  final Scene scene;
  final List<Light> lights;
  private final int maxReflections;
  private final int maxRefractions;

  /**
   * @param maxReflections how many mirrors a path may meet, at least 0
   * @param maxRefractions how many glass surfaces a path may meet, at least 0
   */
  public RayTracer(Scene scene, int maxReflections, int maxRefractions) {
    this.scene = Objects.requireNonNull(scene, "scene");
    this.lights = scene.lights();
    this.maxReflections = maxReflections;
    this.maxRefractions = maxRefractions;
  }

  /** A ray still to be followed, what it counts for, and what it has met. */
  record Branch(Ray ray, Rgb throughput, int reflections, int refractions) {}

  @Override
  public Rgb radiance(Ray cameraRay, Sampler sampler, Scratch scratch) {
    Deque<Branch> pending = scratch.branches;
    pending.clear();
    pending.push(new Branch(cameraRay, Rgb.WHITE, 0, 0));
    double r = 0;
    double g = 0;
    double b = 0;
    for (int number = 0; !pending.isEmpty(); number++) {
      Rgb light = follow(pending.pop(), number, sampler, scratch, pending);
      r += light.r();
      g += light.g();
      b += light.b();
    }
    return new Rgb(r, g, b);
  }

  /** Returns the light that a branch finds at its end, and adds the branches that begin there. */
  Rgb follow(Branch branch, int number, Sampler sampler, Scratch scratch, Deque<Branch> pending) {
    NearestHit hit = scratch.hit;
    scratch.rays++;
    if (!scene.intersect(branch.ray(), hit)) {
      return branch.throughput().times(scene.background(branch.ray().direction()));
    }
    scratch.metSomething = true;
    SurfaceHit surface = scene.surfaceAt(hit);
    Primitive primitive = scene.primitiveAt(hit);
    if (primitive.emission().isPresent()) {
      return branch
          .throughput()
          .times(
              primitive
                  .emission()
                  .get()
                  .towards(surface.wo(), surface.geometricNormal(), surface.texture()));
    }
    Vertex vertex = scratch.vertex;
    vertex.moveTo(surface, primitive.material());
    if (vertex.bsdf() instanceof Dielectric glass) {
      double lobe = sampler.get1d(Sampler.vertex(number) + Sampler.LOBE);
      splitAtGlass(branch, glass, lobe, scratch, pending);
      return Rgb.BLACK;
    }
    if (vertex.bsdf() instanceof RoughDielectric) {
      int dimension = Sampler.vertex(number);
      scatterInGlass(branch, sampler, dimension, scratch, pending);
      return branch.throughput().times(direct(vertex, number, sampler, scratch));
    }
    if (vertex.bsdf().isSpecular()) {
      reflect(branch, scratch, pending);
      return Rgb.BLACK;
    }
    return branch.throughput().times(direct(vertex, number, sampler, scratch));
  }

  private Rgb direct(Vertex vertex, int number, Sampler sampler, Scratch scratch) {
    Rgb ambient = scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
    double r = ambient.r();
    double g = ambient.g();
    double b = ambient.b();
    for (int i = 0; i < lights.size(); i++) {
      int dimension = Sampler.vertex(number * lights.size() + i) + Sampler.LIGHT_POINT;
      LightSample light = scratch.light;
      light.ask(vertex.surface().position(), sampler.get2d(dimension));
      lights.get(i).sample(light);
      if (!light.isEmpty()) {
        Rgb arriving = arriving(i, light, vertex, scratch);
        r += arriving.r();
        g += arriving.g();
        b += arriving.b();
      }
    }
    return new Rgb(r, g, b);
  }

  /**
   * Returns the light of one sample that scatters to the viewer.
   *
   * @param number of the light in the scene's list of lights
   */
  Rgb arriving(int number, LightSample light, Vertex vertex, Scratch scratch) {
    BsdfValue value = scratch.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    boolean arrives = !isBlack && !scratch.isOccluded(scene, vertex.surface());
    // One place makes the result, so that the compiler need not make it at all.
    double weight = light.isDelta() ? 1 : 1 / light.pdf();
    return new Rgb(arrives ? r * weight : 0, arrives ? g * weight : 0, arrives ? b * weight : 0);
  }

  private void reflect(Branch branch, Scratch scratch, Deque<Branch> pending) {
    BsdfSample mirrored = scratch.scattered;
    scratch.vertex.sample(0, MIDDLE, mirrored);
    if (branch.reflections() < maxReflections && !mirrored.isAbsorbed()) {
      pending.push(
          new Branch(
              scratch.vertex.surface().spawn(mirrored.wi()),
              branch.throughput().times(mirrored.weight()),
              branch.reflections() + 1,
              branch.refractions()));
    }
  }

  /** Follows one random direction through ground glass, which has no two to split into. */
  private void scatterInGlass(
      Branch branch, Sampler sampler, int dimension, Scratch scratch, Deque<Branch> pending) {
    if (branch.refractions() < maxRefractions) {
      BsdfSample either = scratch.scattered;
      scratch.vertex.sample(
          sampler.get1d(dimension + Sampler.LOBE),
          sampler.get2d(dimension + Sampler.DIRECTION),
          either);
      pushGlass(branch, scratch.vertex, either.wi(), either.weight(), pending);
    }
  }

  private void splitAtGlass(
      Branch branch, Dielectric glass, double lobe, Scratch scratch, Deque<Branch> pending) {
    Vertex vertex = scratch.vertex;
    if (branch.refractions() >= maxRefractions) {
      return;
    }
    if (branch.refractions() >= MAX_SPLITS) {
      BsdfSample either = scratch.scattered;
      vertex.sample(lobe, MIDDLE, either);
      pushGlass(branch, vertex, either.wi(), either.weight(), pending);
      return;
    }
    double reflected = glass.reflected(vertex.wo());
    Vec3 mirror = new Vec3(-vertex.wo().x(), -vertex.wo().y(), vertex.wo().z());
    pushGlass(
        branch, vertex, vertex.toWorld(mirror), glass.reflectance().times(reflected), pending);
    if (reflected < 1) {
      pushGlass(
          branch,
          vertex,
          vertex.toWorld(glass.refract(vertex.wo())),
          glass.transmittance().times(1 - reflected),
          pending);
    }
  }

  private void pushGlass(
      Branch branch, Vertex vertex, Vec3 direction, Rgb weight, Deque<Branch> pending) {
    if (!weight.isBlack()) {
      pending.push(
          new Branch(
              vertex.surface().spawn(direction),
              branch.throughput().times(weight),
              branch.reflections(),
              branch.refractions() + 1));
    }
  }
}
