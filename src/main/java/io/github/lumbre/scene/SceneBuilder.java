package io.github.lumbre.scene;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Unlit;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** Collects a scene. Mutable; what it builds is not. */
public final class SceneBuilder {
  final Camera camera;
  final List<Primitive> primitives = new ArrayList<>();
  final List<Light> lights = new ArrayList<>();
  final List<Light> emitters = new ArrayList<>();
  final Map<Integer, Integer> emitterOfPrimitive = new HashMap<>();
  Rgb ambient = Rgb.BLACK;
  private Optional<Kernel> kernel = Optional.empty();

  SceneBuilder(Camera camera) {
    this.camera = Objects.requireNonNull(camera, "camera");
  }

  /** Adds a surface that only scatters. */
  public SceneBuilder add(Shape shape, Material material) {
    primitives.add(new Primitive(shape, material, Optional.empty()));
    return this;
  }

  /** Adds a light without a surface, or a dome. */
  public SceneBuilder add(Light light) {
    if (!light.isBlack()) {
      lights.add(light);
      emitters.add(light);
    }
    return this;
  }

  /** Adds a lamp: a surface that shines, scatters nothing, and is a light in both modes. */
  public SceneBuilder addAreaLight(Shape shape, Emission emission) {
    AreaLight light = new AreaLight(shape, emission);
    addEmissive(shape, emission);
    if (!light.isBlack()) {
      lights.add(light);
    }
    return this;
  }

  /**
   * Adds a surface that shows its own colour and scatters nothing. Where all light is followed it
   * lights other things; infinite planes only by being hit.
   */
  public SceneBuilder addEmissive(Shape shape, Emission emission) {
    if (!emission.isBlack() && Double.isFinite(shape.area())) {
      emitterOfPrimitive.put(primitives.size(), emitters.size());
      emitters.add(new AreaLight(shape, emission));
    }
    primitives.add(new Primitive(shape, Unlit.INSTANCE, Optional.of(emission)));
    return this;
  }

  /** Adds a uniform glow from all around, which lights surfaces where all light is followed. */
  public SceneBuilder addBackground(Rgb radiance) {
    if (!radiance.isBlack()) {
      emitters.add(EnvironmentLight.uniform(radiance));
    }
    return this;
  }

  /** Adds irradiance that reaches every diffuse surface from nowhere in particular. */
  public SceneBuilder addAmbient(Rgb irradiance) {
    ambient = ambient.plus(irradiance);
    return this;
  }

  /**
   * Sets how rays find what they hit; without it, the kernel is {@link Kernel#AUTO}. It changes no
   * bit of a picture.
   */
  public SceneBuilder searchedBy(Kernel newKernel) {
    kernel = Optional.of(newKernel);
    return this;
  }

  /** Returns how many primitives there are so far. */
  public int primitiveCount() {
    return primitives.size();
  }

  /** Returns how many emitters there are so far. */
  public int emitterCount() {
    return emitters.size();
  }

  Kernel kernel() {
    return kernel.orElse(Kernel.AUTO);
  }

  /**
   * Returns the scene.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public Scene build() {
    return new Scene(this);
  }
}
