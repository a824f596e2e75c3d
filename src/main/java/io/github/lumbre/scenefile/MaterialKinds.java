package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Channel;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scenefile.MaterialReader.Stated;
import io.github.lumbre.texture.Texture;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The materials of scene files. */
final class MaterialKinds {
  static final Family<Function<Stated, Surface>> FAMILY =
      new Family<>("materialType", Optional.empty(), "a material", ObjectKeys.OF_ASSETS);

  static final Key<Double> NORMAL =
      Key.normals("normal", "By which the map's slopes are multiplied.");

  private static final Key<Rgb> COLOR =
      Key.color("color", "What the surface scatters or emits, linear; times the texture.")
          .varied(0, 1);
  private static final Key<Rgb> SPECULAR =
      Key.color("specularColor", "What the gloss reflects, linear.").varied(0, 1);
  private static final Key<Rgb> REFLECTED =
      Key.color("reflectivityColor", "What is reflected, linear.").varied(0, 1);
  private static final Key<Rgb> REFRACTED =
      Key.color("refractionColor", "What passes, linear.").varied(0, 1);
  private static final Key<Boolean> MULTIPLE_SCATTERING =
      Key.flag(
              "multipleScattering",
              false,
              "Whether light that hits more than one facet is kept; with ggx only.")
          .omitted();

  /** A surface that emits light and does not scatter any. */
  static final Kind<Function<Stated, Surface>, Emission> EMISSIVE;

  /** An area light. */
  static final Kind<Function<Stated, Surface>, Emission> AREA_LIGHT;

  static {
    kind("Diffuse", Matte.class, in -> new Matte(reflectance(in, COLOR)))
        .color(COLOR, Matte::albedo)
        .with(NORMAL);
    EMISSIVE =
        FAMILY
            .kind(
                "Color",
                Emission.class,
                in -> {
                  Emission emission = new Emission(in.color(COLOR), true);
                  return (shape, scene) -> scene.add(shape, Unlit.INSTANCE, emission);
                })
            .color(COLOR, Emission::radiance);
    Key<Boolean> inside = Key.flag("twoSided", false, "Whether the inside emits as well.");
    // An infinite plane cannot be sampled; it is as one of type Color.
    AREA_LIGHT =
        FAMILY
            .kind(
                "AreaLight",
                Emission.class,
                in -> {
                  Emission emission = new Emission(in.color(COLOR), in.get(inside));
                  return (shape, scene) -> scene.addAreaLight(shape, emission);
                })
            .with(inside, Emission::twoSided)
            .color(COLOR, Emission::radiance);
    kind("Reflective", Mirror.class, in -> new Mirror(reflectance(in, REFLECTED)))
        .color(REFLECTED, Mirror::reflectance)
        .with(NORMAL);
    glass();
    FAMILY.kind("None", Void.class, in -> Surface.DEFAULT);
    gloss();
    kind("ShadowCatcher", ShadowCatcher.class, in -> new ShadowCatcher(reflectance(in, COLOR)))
        .color(COLOR, catcher -> catcher.surface().albedo());
    metallicRoughness();
    FAMILY.refuse("Unlit", "a material of the format", "Unlit");
    FAMILY.refuse("UniformMaterial", "a material of the format", "UniformMaterial");
  }

  private MaterialKinds() {}

  private static <M extends Material> Kind<Function<Stated, Surface>, M> kind(
      String name, Class<M> type, Function<Stated, M> reading) {
    return FAMILY.kind(name, type, in -> in.surface(reading.apply(in)));
  }

  private static Texture<Rgb> reflectance(Stated in, Key<Rgb> key) {
    return in.reflectances(key).get(0);
  }

  private static void glass() {
    Key<Double> ior = ior(1);
    Key<Double> roughness = roughness(0);
    kind(
            "Refractive",
            Glass.class,
            in -> {
              List<Texture<Rgb>> both = in.reflectances(REFLECTED, REFRACTED);
              return new Glass(
                  both.get(0),
                  both.get(1),
                  in.number(ior),
                  in.number(roughness),
                  in.get(MULTIPLE_SCATTERING));
            })
        .color(REFLECTED, Glass::reflectance)
        .color(REFRACTED, Glass::transmittance)
        .number(ior, Glass::ior)
        .number(roughness, Glass::roughness)
        .with(MULTIPLE_SCATTERING, Glass::multipleScattering)
        .with(NORMAL);
  }

  private static void gloss() {
    Key<Double> exponent =
        Key.number("exponent", Range.NOT_NEGATIVE, 1, "Of the gloss.").varied(0, Double.MAX_VALUE);
    kind(
            "Phong",
            Phong.class,
            in -> {
              List<Texture<Rgb>> both = in.sum(COLOR, SPECULAR);
              return new Phong(both.get(0), both.get(1), in.number(exponent));
            })
        .color(COLOR, Phong::diffuse)
        .color(SPECULAR, Phong::specular)
        .number(exponent, Phong::exponent)
        .with(NORMAL);
    Key<Double> roughness = roughness(1);
    Key<Double> ior = ior(CookTorrance.DEFAULT_IOR);
    Key<MicrofacetDistribution> distribution =
        Key.choice("distribution", MicrofacetDistribution.BECKMANN, "");
    kind(
            "CookTorrance",
            CookTorrance.class,
            in -> {
              List<Texture<Rgb>> both = in.sum(COLOR, SPECULAR);
              MicrofacetDistribution facets = in.get(distribution);
              return new CookTorrance(
                  both.get(0),
                  both.get(1),
                  in.number(roughness),
                  in.number(ior),
                  facets,
                  scattersRepeatedly(in, facets));
            })
        .color(COLOR, CookTorrance::diffuse)
        .color(SPECULAR, CookTorrance::specular)
        .number(roughness, CookTorrance::roughness)
        .number(ior, CookTorrance::ior)
        .with(distribution, CookTorrance::distribution)
        .with(MULTIPLE_SCATTERING, CookTorrance::multipleScattering)
        .with(NORMAL);
  }

  private static boolean scattersRepeatedly(Stated in, MicrofacetDistribution facets) {
    boolean isStated = in.get(MULTIPLE_SCATTERING);
    if (isStated && facets != MicrofacetDistribution.GGX) {
      MULTIPLE_SCATTERING.error(
          in.node(),
          "expected false with the distribution beckmann, found true; add \"distribution\":"
              + " \"ggx\"");
    }
    return isStated && facets == MicrofacetDistribution.GGX;
  }

  private static Key<Double> ior(double defaultValue) {
    return Key.number("ior", Dielectric.IOR, defaultValue, "Index of refraction.")
        .varied(1, Dielectric.IOR.high());
  }

  private static Key<Double> roughness(double defaultValue) {
    return Key.number("roughness", Range.FRACTION, defaultValue, "From smooth to rough.")
        .varied(0, 1);
  }

  private static void metallicRoughness() {
    Key<Boolean> twoSided =
        Key.flag("twoSided", true, "Whether back faces are visible.").omitted();
    Map<MaterialParameter, Key<?>> keys = new LinkedHashMap<>();
    Kind<?, MetallicRoughness> kind =
        kind(
            "MetallicRoughness",
            MetallicRoughness.class,
            in -> {
              MetallicRoughness.Builder builder = MetallicRoughness.builder();
              keys.forEach(
                  (parameter, key) ->
                      channel(in, parameter, key)
                          .filter(channel -> key.isIn(in.node()))
                          .ifPresent(channel -> builder.set(parameter, channel)));
              return (in.get(twoSided) ? builder : builder.singleSided()).build();
            });
    for (MaterialParameter parameter : MaterialParameter.all()) {
      Key<?> key = key(parameter);
      keys.put(parameter, key);
      kind.with(key)
          .writing(
              (material, to, textures) ->
                  material.stated(parameter).ifPresent(value -> put(to, key, value, textures)));
    }
    kind.with(twoSided, MetallicRoughness::isDoubleSided).with(NORMAL);
  }

  private static Key<?> key(MaterialParameter parameter) {
    String name = parameter.key();
    String meaning = parameter.meaning();
    return switch (parameter.kind()) {
      case COLOR -> varied(parameter, Key.of(name, Value.COLOR, parameter.defaultValue(), meaning));
      case NORMALS -> Key.normals(name, meaning);
      case NUMBER ->
          varied(
              parameter, Key.number(name, range(parameter), parameter.defaultValue().r(), meaning));
    };
  }

  private static <T> Key<T> varied(MaterialParameter parameter, Key<T> key) {
    return parameter.isTextured() ? key.varied(parameter.least(), parameter.most()) : key;
  }

  private static Range range(MaterialParameter parameter) {
    if (parameter == MaterialParameter.ATTENUATION_DISTANCE) {
      return Range.POSITIVE;
    }
    Range closed = Range.closed(parameter.least(), parameter.most());
    return parameter.accepts(0) && !closed.contains(0) ? closed.orZero() : closed;
  }

  @SuppressWarnings("unchecked") // The key has the kind of the parameter.
  private static Optional<Channel> channel(Stated in, MaterialParameter parameter, Key<?> key) {
    return switch (parameter.kind()) {
      case COLOR -> Optional.of(Channel.color(reflectance(in, (Key<Rgb>) key), 0));
      case NUMBER -> Optional.of(Channel.number(in.number((Key<Double>) key), 0));
      case NORMALS -> in.normals((Key<Double>) key).map(map -> new NormalChannel(map, 0));
    };
  }

  @SuppressWarnings("unchecked") // The key has the kind of the parameter.
  private static void put(JsonObject to, Key<?> key, Channel value, TextureWriter textures) {
    if (value instanceof ColorChannel.Textured color && color.uvSet() == 0) {
      textures.color(to, (Key<Rgb>) key, color.texture());
    } else if (value instanceof ScalarChannel.Textured number && number.uvSet() == 0) {
      textures.number(to, (Key<Double>) key, number.texture());
    } else if (value instanceof NormalChannel normals && normals.uvSet() == 0) {
      textures.normalMap(to, (Key<Double>) key, normals.map());
    } else {
      throw new Unwritable(
          key.stem() + ": a texture with the first texture coordinates", Unwritable.name(value));
    }
  }
}
