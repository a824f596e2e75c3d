package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** Reads lights, and converts the format's intensity to the unit of each light type. */
final class LightReader {
  /** Rotates a rectangle, whose normal is +y, to the format's direction of emission, +z. */
  private static final Transform UPRIGHT = Transform.rotationDegrees(new Vec3(90, 0, 0));

  /** The unit of an area light's intensity. */
  enum Unit {
    /**
     * The format's own unit: radiance for lights of local area 1 or less, and radiance times local
     * area for larger ones.
     */
    FORMAT {
      @Override
      double radiance(double localArea, double worldArea) {
        return 1 / Math.max(1, localArea);
      }
    },
    RADIANCE {
      @Override
      double radiance(double localArea, double worldArea) {
        return 1;
      }
    },
    POWER {
      @Override
      double radiance(double localArea, double worldArea) {
        return 1 / (Math.PI * worldArea);
      }
    };

    /** Returns the radiance of a light of intensity 1; areas are before and after its transform. */
    abstract double radiance(double localArea, double worldArea);
  }

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
    double missing = LightKinds.PROFILE.isIn(node) ? 1 : 0;
    String key = LightKinds.INTENSITY.name();
    Rgb intensity = LightKinds.COLOR.in(node).times(LightKinds.INTENSITY.in(node, missing));
    if (intensity.isBlack()) {
      node.warn(key, "the light emits nothing");
    }
    if (!intensity.isFinite()) {
      node.error(key, "expected a finite product with the color, found an infinite one");
      return Optional.empty();
    }
    return LightKinds.FAMILY.choose(node).map(kind -> kind.read(this, light, intensity));
  }

  Consumer<SceneAssembly> directional(Placed light, Rgb irradiance) {
    warnOfGlass(light);
    DirectionalLight made = new DirectionalLight(axis(light), irradiance);
    return scene -> scene.add(made);
  }

  Consumer<SceneAssembly> point(Placed light, Rgb intensity) {
    warnOfGlass(light);
    if (LightKinds.PROFILE.isIn(light.node())) {
      return profiled(light, intensity);
    }
    PointLight made = pointLight(light, intensity, Falloff.NONE);
    return scene -> scene.add(made);
  }

  private Consumer<SceneAssembly> profiled(Placed light, Rgb factor) {
    PointLight source = pointLight(light, factor, Falloff.INVERSE_SQUARE);
    if (source.falloff() == Falloff.NONE) {
      LightKinds.FALLOFF.error(
          light.node(), "expected \"inverseSquare\", which profiles need, found \"none\"");
    }
    Optional<LightProfile> profile = profiles.of(light.node());
    return scene -> scene.add(profile.orElseThrow().light(source, light.toWorld()));
  }

  Consumer<SceneAssembly> spot(Placed light, Rgb intensity) {
    warnOfGlass(light);
    if (LightKinds.PROFILE.isIn(light.node())) {
      LightKinds.PROFILE.warn(light.node(), "is ignored, because only Point lights have one");
    }
    double angle = spotAngle(light.node());
    double penumbra = light.node().number(LightKinds.PENUMBRA.name(), 0, Range.closed(0, angle));
    PointLight source = pointLight(light, intensity, Falloff.NONE);
    SpotLight made = new SpotLight(source, axis(light), angle, penumbra);
    return scene -> scene.add(made);
  }

  private static double spotAngle(JsonNode light) {
    double written = LightKinds.SPOT_ANGLE.in(light);
    double angle = Math.min(90, Math.abs(written));
    if (angle != written) {
      light.warn(
          LightKinds.SPOT_ANGLE.name(),
          PrintableText.number(written) + " is treated as " + PrintableText.number(angle));
    }
    return angle;
  }

  Consumer<SceneAssembly> ambient(Placed light, Rgb irradiance) {
    return scene -> scene.addAmbient(irradiance);
  }

  Consumer<SceneAssembly> rectangle(Placed light, Rgb intensity) {
    double width = LightKinds.WIDTH.in(light.node());
    double height = LightKinds.HEIGHT.in(light.node());
    Shape shape = new Rectangle(light.toWorld().times(UPRIGHT), width, height, false);
    return lamp(light, intensity, shape, width * height);
  }

  Consumer<SceneAssembly> sphere(Placed light, Rgb intensity) {
    double radius = LightKinds.RADIUS.in(light.node());
    Shape shape = new Sphere(light.toWorld(), radius);
    return lamp(light, intensity, shape, 4 * Math.PI * radius * radius);
  }

  private Consumer<SceneAssembly> lamp(Placed light, Rgb intensity, Shape shape, double localArea) {
    Unit unit = LightKinds.UNIT.in(light.node(), Unit.FORMAT);
    boolean measurable = ShapeReader.isMeasurable(light.node().spot(), shape);
    Rgb radiance = measurable ? intensity.times(unit.radiance(localArea, shape.area())) : Rgb.BLACK;
    if (!radiance.isFinite()) {
      intensityError(light, "expected a finite radiance, found an infinite one");
    }
    Emission emission = new Emission(Texture.constant(radiance), false);
    return scene -> scene.addAreaLight(shape, emission);
  }

  Consumer<SceneAssembly> dome(Placed light, Rgb radiance) {
    hasDome = true;
    boolean isFinite = radiance.max() <= EnvironmentLight.MAX_RADIANCE;
    if (!isFinite) {
      String most = PrintableText.number(EnvironmentLight.MAX_RADIANCE);
      intensityError(light, "expected a product with the color of at most " + most);
    }
    Rgb used = isFinite ? radiance : Rgb.BLACK;
    EnvironmentLight made = textures.dome(light.node(), light.axes(), used);
    return scene -> scene.add(made);
  }

  private static void intensityError(Placed light, String message) {
    LightKinds.INTENSITY.error(light.node(), message);
  }

  private static PointLight pointLight(Placed light, Rgb intensity, Falloff missing) {
    Falloff falloff = LightKinds.FALLOFF.in(light.node(), missing);
    return new PointLight(light.position(), intensity, falloff);
  }

  private static Vec3 axis(Placed light) {
    return ObjectKeys.MATRIX.isIn(light.node())
        ? Directions.axis(light.toWorld())
        : light.toWorld().vector(Vec3.Z).normalized();
  }

  private void warnOfGlass(Placed light) {
    if (hasGlass && !warnedOfGlass) {
      light
          .node()
          .warn(
              LightKinds.FAMILY.typeKey().name(),
              "the scene has glass, which blocks light from Directional, Point and Spot lights");
      warnedOfGlass = true;
    }
  }
}
