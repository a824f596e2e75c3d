package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scene.internal.SceneNode;
import io.github.lumbre.scenefile.LightReader.Stated;
import io.github.lumbre.texture.internal.ClearSky;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/** The lights of scene files. */
final class LightKinds {
  /** A computed sky. */
  enum Sky {
    STUDIO,
    RELIEF,
    CLEAR,
    SUN
  }

  /** The unit of an area light's intensity; without one, radiance times a local area above 1. */
  enum Unit {
    RADIANCE,
    POWER
  }

  /** Rotates a rectangle, whose normal is +y, to the format's direction of emission, +z. */
  private static final Transform UPRIGHT = Transform.rotationDegrees(new Vec3(90, 0, 0));

  static final Family<Function<Stated, Consumer<SceneAssembly>>> FAMILY =
      new Family<>("lightType", Optional.empty(), "a light", ObjectKeys.OF_EMITTERS);

  /** The kind of the lights of the sky. */
  static final String DOME = "Dome";

  static final Key<Double> INTENSITY =
      Key.number(
          "intensity",
          Range.NOT_NEGATIVE,
          0,
          "Times the color; see docs/scene-format.md for its unit. With a profile, a factor, by"
              + " default 1.");
  static final Key<Rgb> COLOR = Key.color("color", "");
  static final Key<Falloff> FALLOFF =
      Key.choice("falloff", Value::camelCase, Falloff.NONE, "");
  static final Key<String> PROFILE =
      Key.of(
          "profile", Value.TEXT, "IES file of a lamp (LM-63), relative to the scene's folder.");
  static final Key<Double> SPOT_ANGLE =
      Key.number(
          "spotAngle",
          new Range(
              Range.ANY.low(),
              Range.ANY.high(),
              angle -> angle != 0 && Range.ANY.contains(angle),
              "an angle other than 0",
              "an angle other than 0"),
          60,
          "Half angle in degrees.");
  static final Key<Double> PENUMBRA =
      Key.number("penumbra", Range.closed(0, 90), 0, "In degrees, at most the spotAngle.");
  static final Key<Unit> UNIT = Key.choice("unit", Unit.RADIANCE, "").withoutDefault();
  static final Key<Double> RADIUS = ShapeKinds.size("radius", "In scene units.");
  static final Key<Double> WIDTH = ShapeKinds.size("width", "Along x.");
  static final Key<Double> HEIGHT = ShapeKinds.size("height", "Along y.");
  static final Key<Integer> TEXTURE = Key.id("textureId");
  static final Key<Sky> SKY =
      Key.choice(
              "sky",
              Sky.STUDIO,
              "A computed sky instead of a texture: a studio, one with more contrast (relief), a"
                  + " clear day's sky, or the sun in it.")
          .withoutDefault();
  static final Key<Double> SUN_AZIMUTH =
      Key.number(
          "sunAzimuth",
          Range.ANY,
          ClearSky.AZIMUTH,
          "Of the sun of a clear sky, in degrees: 0 towards -z, 90 towards +x.");
  static final Key<Double> SUN_ELEVATION =
      Key.number(
          "sunElevation",
          Range.closed(ClearSky.LOWEST, 90),
          ClearSky.ELEVATION,
          "Of the sun of a clear sky, in degrees above the horizon.");

  static {
    small(
            "Directional",
            DirectionalLight.class,
            in -> added(new DirectionalLight(in.axis(), in.strength())))
        .with(COLOR, DirectionalLight::irradiance)
        .writing((light, to, textures) -> pointing(to, Vec3.ZERO, light.direction()));
    small(
            "Point",
            PointLight.class,
            in -> PROFILE.isIn(in.at().node()) ? in.profiled() : added(in.point(Falloff.NONE)))
        .with(COLOR, PointLight::intensity)
        .with(FALLOFF, PointLight::falloff)
        .with(PROFILE)
        .placed(light -> Transform.translation(light.position()));
    small("Spot", SpotLight.class, LightKinds::spot)
        .with(COLOR, light -> light.source().intensity())
        .with(FALLOFF, light -> light.source().falloff())
        .with(SPOT_ANGLE, SpotLight::halfAngleDegrees)
        .with(PENUMBRA, SpotLight::penumbraDegrees)
        .writing((light, to, textures) -> pointing(to, light.source().position(), light.axis()));
    shining("Ambient", SceneNode.Ambient.class, in -> scene -> scene.addAmbient(in.strength()))
        .with(COLOR, SceneNode.Ambient::irradiance);
    // Scenes state area lights that code built as materials, because these may have a texture.
    shining("Rectangle", Void.class, LightKinds::rectangle).with(COLOR, WIDTH, HEIGHT, UNIT);
    shining("Sphere", Void.class, LightKinds::sphere).with(COLOR, RADIUS, UNIT);
    FAMILY
        .kind(DOME, EnvironmentLight.class, Stated::dome)
        .with(TEXTURE, SKY, SUN_AZIMUTH, SUN_ELEVATION, INTENSITY, COLOR)
        .writing(LightKinds::dome);
    FAMILY.refuse("ProfileLight", "a light without a profile", "the profile of a lamp");
    FAMILY.refuse("AreaLight", "addAreaLight for an area light", "add(Light)");
  }

  private LightKinds() {}

  private static <O> Kind<Function<Stated, Consumer<SceneAssembly>>, O> shining(
      String name, Class<O> type, Function<Stated, Consumer<SceneAssembly>> reading) {
    return FAMILY.kind(name, type, reading).with(INTENSITY).writing((o, to, t) -> shine(to));
  }

  /** Adds a light that is as small as a point, and does not shine through glass. */
  private static <O> Kind<Function<Stated, Consumer<SceneAssembly>>, O> small(
      String name, Class<O> type, Function<Stated, Consumer<SceneAssembly>> reading) {
    return shining(
        name,
        type,
        in -> {
          in.warnOfGlass();
          return reading.apply(in);
        });
  }

  private static Consumer<SceneAssembly> added(Light light) {
    return scene -> scene.add(light);
  }

  private static Consumer<SceneAssembly> spot(Stated in) {
    JsonNode node = in.at().node();
    if (PROFILE.isIn(node)) {
      PROFILE.warn(node, "is ignored, because only Point lights have one");
    }
    double written = SPOT_ANGLE.in(node);
    double angle = Math.min(90, Math.abs(written));
    if (angle != written) {
      SPOT_ANGLE.warn(
          node,
          PrintableText.number(written) + " is treated as " + PrintableText.number(angle));
    }
    double penumbra = PENUMBRA.within(Range.closed(0, angle)).in(node);
    return added(new SpotLight(in.point(Falloff.NONE), in.axis(), angle, penumbra));
  }

  private static Consumer<SceneAssembly> rectangle(Stated in) {
    double width = in.at().get(WIDTH);
    double height = in.at().get(HEIGHT);
    Transform toWorld = in.at().toWorld().times(UPRIGHT);
    return in.lamp(new Rectangle(toWorld, width, height, false), width * height);
  }

  private static Consumer<SceneAssembly> sphere(Stated in) {
    double radius = in.at().get(RADIUS);
    return in.lamp(new Sphere(in.at().toWorld(), radius), 4 * Math.PI * radius * radius);
  }

  /** Writes the intensity of lights whose color is their strength. */
  private static void shine(JsonObject to) {
    to.addProperty(INTENSITY.name(), 1);
  }

  private static void pointing(JsonObject to, Vec3 position, Vec3 direction) {
    LocalTransform.matrix(to, Directions.pointing(position, direction));
  }

  private static void dome(EnvironmentLight sky, JsonObject to, TextureWriter textures) {
    boolean isUniform = sky.grid().isEmpty();
    if (!isUniform && sky.choiceShare() != 1) {
      throw new Unwritable("an environment light without besideSun", "one with it");
    }
    Rgb color = isUniform ? sky.radiance().at(0, 0) : textures.sky(to, sky.radiance());
    shine(to);
    COLOR.put(to, color);
    if (!isUniform) {
      LocalTransform.matrix(to, Transform.ofFrame(sky.axes(), Vec3.ZERO));
    }
  }
}
