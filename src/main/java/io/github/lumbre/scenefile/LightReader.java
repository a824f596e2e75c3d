package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** Reads lights, and converts the format's intensity to the unit of each light type. */
final class LightReader {
  private final TextureReader textures;
  private final LightProfiles profiles;
  private final boolean hasGlass;
  private final Set<String> keys = LightKinds.FAMILY.keys();
  private int count;
  private boolean hasDome;
  private boolean warnedOfGlass;

  /**
   * @param hasGlass whether any object in the scene is made of glass
   */
  LightReader(TextureReader textures, LightProfiles profiles, boolean hasGlass) {
    this.textures = textures;
    this.profiles = profiles;
    this.hasGlass = hasGlass;
  }

  /** Returns the number of lights read so far. */
  int count() {
    return count;
  }

  /** Returns whether an environment light has been read. */
  boolean hasDome() {
    return hasDome;
  }

  /** Returns an action that adds the light to a scene; empty if the light has errors. */
  Optional<Consumer<SceneAssembly>> read(Placed light) {
    JsonNode node = light.node();
    node.warnUnknown(keys);
    count++;
    double otherwise = LightKinds.PROFILE.isIn(node) ? 1 : 0;
    Rgb strength = light.get(LightKinds.COLOR).times(LightKinds.INTENSITY.in(node, otherwise));
    if (strength.isBlack()) {
      LightKinds.INTENSITY.warn(node, "the light emits nothing");
    }
    if (!strength.isFinite()) {
      LightKinds.INTENSITY.error(
          node, "expected a finite product with the color, found an infinite one");
      return Optional.empty();
    }
    return LightKinds.FAMILY.choose(node).map(kind -> kind.apply(new Stated(light, strength)));
  }

  /** What a light states. */
  final class Stated {
    private final Placed at;
    private final Rgb strength;

    private Stated(Placed at, Rgb strength) {
      this.at = at;
      this.strength = strength;
    }

    Placed at() {
      return at;
    }

    /** Returns the intensity times the color. */
    Rgb strength() {
      return strength;
    }

    /** Returns the direction of emission. */
    Vec3 axis() {
      return ObjectKeys.MATRIX.isIn(at.node())
          ? Directions.axis(at.toWorld())
          : at.toWorld().vector(Vec3.Z).normalized();
    }

    void warnOfGlass() {
      if (hasGlass && !warnedOfGlass) {
        LightKinds.FAMILY
            .typeKey()
            .warn(
                at.node(),
                "the scene has glass, which blocks light from Directional, Point and Spot lights");
        warnedOfGlass = true;
      }
    }

    PointLight point(Falloff otherwise) {
      Falloff falloff = LightKinds.FALLOFF.in(at.node(), otherwise);
      return new PointLight(at.position(), strength, falloff);
    }

    Consumer<SceneAssembly> profiled() {
      PointLight source = point(Falloff.INVERSE_SQUARE);
      if (source.falloff() == Falloff.NONE) {
        LightKinds.FALLOFF.error(
            at.node(), "expected \"inverseSquare\", which profiles need, found \"none\"");
      }
      Optional<LightProfile> profile = profiles.of(at.node());
      return scene -> scene.add(profile.orElseThrow().light(source, at.toWorld()));
    }

    /**
     * Returns an area light.
     *
     * @param localArea of the shape before its transform
     */
    Consumer<SceneAssembly> lamp(Shape shape, double localArea) {
      double perUnit = radiance(shape, localArea);
      boolean isMeasurable = ShapeReader.isMeasurable(at.node().problemPlace(), shape.bounds());
      Rgb radiance = isMeasurable ? strength.times(perUnit) : Rgb.BLACK;
      if (!radiance.isFinite()) {
        LightKinds.INTENSITY.error(
            at.node(), "expected a finite radiance, found an infinite one");
      }
      Emission emission = new Emission(Texture.constant(radiance), false);
      return scene -> scene.addAreaLight(shape, emission);
    }

    /** Returns the radiance of an intensity of 1. */
    private double radiance(Shape shape, double localArea) {
      return at.stated(LightKinds.UNIT)
          .map(unit -> unit == LightKinds.Unit.POWER ? 1 / (Math.PI * shape.area()) : 1)
          .orElse(1 / Math.max(1, localArea));
    }

    Consumer<SceneAssembly> dome() {
      hasDome = true;
      boolean isFinite = strength.max() <= EnvironmentLight.MAX_RADIANCE;
      if (!isFinite) {
        String most = PrintableText.number(EnvironmentLight.MAX_RADIANCE);
        LightKinds.INTENSITY.error(
            at.node(), "expected a product with the color of at most " + most);
      }
      EnvironmentLight made =
          textures.dome(at.node(), at.axes(), isFinite ? strength : Rgb.BLACK);
      return scene -> scene.add(made);
    }
  }
}
