package io.github.lumbre.model.format.obj;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.format.ObjTextures;
import io.github.lumbre.model.format.PhongReflection;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Converts a material of a library to a metallic-roughness material.
 *
 * <ul>
 *   <li>The base color is {@code Kd} times {@code map_Kd}. Numbers are linear; pictures are
 *       sRGB-encoded. A factor of 0 with a picture means 1, as exporters write it so.
 *   <li>A material with {@code Pr}, {@code Pm}, {@code Pc}, {@code Pcr} or {@code Ps} has these
 *       values as perceptual roughness, metalness, strength and roughness of the clear coat, and
 *       sheen.
 *   <li>Other materials are Phong materials: not metallic, with perceptual roughness (2 / (Ns +
 *       2))^(1/4), since a Beckmann distribution of that roughness, α² = 2 / (Ns + 2), has the
 *       highlights of a Blinn-Phong exponent Ns (Walter et al. 2007, sec. 5.2). Reflectance at
 *       normal incidence is 0.08 {@code Ks}, so that the usual 0.5 is glass or plastic of index
 *       1.5. With {@code illum} 3, 5 and 8, which reflect the surroundings, it is {@code Ks}. With
 *       {@code illum} 0 and 1, there is no reflection.
 *   <li>{@code illum} 6 and 7 refract: the transmission is 1 − d, or 1 if d = 1, with index {@code
 *       Ni} and color {@code Tf}. Otherwise, {@code d}, or 1 − {@code Tr}, is the opacity. {@code
 *       Tr 1} without {@code d} is opaque, since several tools write it so.
 *   <li>A {@code map_Bump} with colors is a normal map; height maps are ignored.
 *   <li>A picture that is missing is left out with a warning, and a number out of its range is
 *       replaced with one.
 * </ul>
 */
final class MtlConversion {
  private static final double DEFAULT_SHEEN_ROUGHNESS = .5;

  /** Keys that libraries do not write with a capital letter. */
  private static final Set<String> LOWER_CASE = Set.of("d", "illum");

  /** The illumination model with diffuse light and highlights. */
  private static final double DEFAULT_ILLUMINATION = 2;

  private static final int LAST_ILLUMINATION = 10;

  /** The largest difference from a range that is a rounding error. */
  private static final double ROUNDING = 1e-6;

  private final MtlMaterial in;
  private final ObjTextures textures;
  private final Warnings warnings;
  private final ModelMaterial.Builder out;

  MtlConversion(MtlMaterial in, ObjTextures textures, Warnings warnings) {
    this.in = in;
    this.textures = textures;
    this.warnings = warnings;
    out = PlainModel.matte(in.name(), in.location());
  }

  ModelMaterial material() throws ModelFormatException, IOException {
    out.set(BASE_COLOR, color("kd", Rgb.gray(PlainModel.ALBEDO)));
    out.emission(color("ke", Rgb.BLACK));
    out.normalMap(normalMap());
    if (MaterialParameter.all().stream().anyMatch(p -> in.has(p.mtl()))) {
      setPhysical();
    } else {
      setPhong();
    }
    if (illumination() == 6 || illumination() == 7) {
      setRefraction();
    } else {
      setOpacity();
    }
    return out.build();
  }

  private int illumination() {
    int stated = in.number("illum").orElse(DEFAULT_ILLUMINATION).intValue();
    if (stated >= 0 && stated <= LAST_ILLUMINATION) {
      return stated;
    }
    warn("illum", "0 to 10", stated, DEFAULT_ILLUMINATION);
    return (int) DEFAULT_ILLUMINATION;
  }

  /** Returns a number of the material in a range; adds a warning if it is out of it. */
  private double limited(String key, double stated, double min, double max) {
    double limited = Math.max(min, Math.min(stated, max));
    if (Math.abs(limited - stated) > ROUNDING) {
      String range = PrintableText.number(min) + " to " + PrintableText.number(max);
      warn(key, max == Double.MAX_VALUE ? "at least 0" : range, stated, limited);
    }
    return limited;
  }

  private Rgb limited(String key, Rgb stated, double max) {
    return new Rgb(
        limited(key, stated.r(), 0, max),
        limited(key, stated.g(), 0, max),
        limited(key, stated.b(), 0, max));
  }

  /** Adds a warning of a number that is replaced. */
  private void warn(String key, String expected, double stated, double used) {
    warnings.add(
        "a number of a material is out of range",
        in.location(),
        "%s: expected %s, found %s; %s is used"
            .formatted(
                LOWER_CASE.contains(key)
                    ? key
                    : key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1),
                expected,
                PrintableText.number(stated),
                PrintableText.number(used)));
  }

  private void setPhysical() throws ModelFormatException, IOException {
    out.set(ROUGHNESS, phongRoughness());
    for (MaterialParameter parameter : MaterialParameter.all()) {
      if (in.has(parameter.mtl())) {
        out.set(parameter, scalar(parameter, parameter == ROUGHNESS ? phongRoughness() : 0));
      }
    }
    out.set(SHEEN_ROUGHNESS, DEFAULT_SHEEN_ROUGHNESS);
    out.set(SPECULAR, 1);
    out.set(IOR, ior());
  }

  private void setPhong() throws ModelFormatException, IOException {
    MaterialInput reflectance = color("ks", Rgb.BLACK);
    int illumination = illumination();
    if (reflectance.factor().isBlack() || illumination < 2) {
      return;
    }
    boolean reflects = illumination == 3 || illumination == 5 || illumination == 8;
    PhongReflection.set(out, reflectance, reflects, exponent());
  }

  private double phongRoughness() {
    return PhongReflection.roughness(exponent());
  }

  private double exponent() {
    return limited("ns", in.number("ns").orElse(0.), 0, Double.MAX_VALUE);
  }

  private void setRefraction() {
    double opacity = opacity();
    out.set(TRANSMISSION, opacity < 1 ? 1 - opacity : 1);
    out.set(BASE_COLOR, limited("tf", in.color("tf").orElse(Rgb.WHITE), 1));
    out.set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY);
    out.set(SPECULAR, 1);
    out.set(SPECULAR_COLOR, Rgb.WHITE);
    out.set(IOR, ior());
    if (in.number("ns").isEmpty() && in.number("pr").isEmpty()) {
      out.set(ROUGHNESS, 0);
    }
  }

  private double ior() {
    return limited("ni", in.number("ni").orElse(1.5), IOR.least(), IOR.most());
  }

  private double opacity() {
    if (in.number("d").isPresent()) {
      return limited("d", in.number("d").get(), 0, 1);
    }
    return isTrOpacity() ? 1 : 1 - limited("tr", in.number("tr").orElse(0.), 0, 1);
  }

  /** Returns whether Tr states an opacity of 1: several tools write that instead of Tr 0. */
  private boolean isTrOpacity() {
    return in.number("d").isEmpty() && in.number("tr").orElse(0.) == 1;
  }

  private void setOpacity() throws ModelFormatException, IOException {
    double opacity = opacity();
    Optional<MtlMap> map = map("map_d");
    Optional<ModelTexture> texture = Optional.empty();
    int channel = 0;
    if (map.isPresent()) {
      texture = Optional.of(textures.texture(map.get()));
      channel = alphaChannel(map.get());
    }
    if (in.map("map_d").isPresent()) {
      // A factor of 0 is not meant, even if the picture is missing.
      opacity = opacity == 0 ? 1 : opacity;
    } else if (isTrOpacity()) {
      warnings.add(in.location(), "took Tr 1 for opaque, since there is no d");
    } else if (opacity == 0) {
      warnings.add(in.location(), "the material is invisible: its opacity, d or 1 - Tr, is 0");
    }
    if (opacity < 1 || map.isPresent()) {
      out.set(OPACITY, new MaterialInput(Rgb.gray(opacity), texture, channel));
      out.alphaMode(AlphaMode.BLEND);
    }
  }

  /** Returns the stated channel; alpha, if the color has the same picture; else red. */
  private int alphaChannel(MtlMap map) {
    boolean isColor = in.map("map_kd").filter(color -> color.file().equals(map.file())).isPresent();
    return map.channel() >= 0 ? map.channel() : isColor ? 3 : 0;
  }

  private Optional<MaterialInput> normalMap() throws ModelFormatException, IOException {
    Optional<MtlMap> norm = map("norm");
    Optional<MtlMap> map = norm.isPresent() ? norm : map("map_bump", "bump");
    if (map.isEmpty()) {
      return Optional.empty();
    }
    if (norm.isEmpty() && textures.isHeightMap(map.get())) {
      warnings.add(map.get().location(), "ignored a height map: only normal maps are supported");
      return Optional.empty();
    }
    return Optional.of(
        new MaterialInput(
            Rgb.gray(map.get().bumpScale()), Optional.of(textures.texture(map.get())), 0));
  }

  private MaterialInput color(String key, Rgb otherwise) throws ModelFormatException, IOException {
    Optional<MtlMap> map = map("map_" + key);
    boolean isMapped = in.map("map_" + key).isPresent();
    if (key.equals("ke") && isMapped && map.isEmpty()) {
      // Without its picture, a surface would glow all over.
      return MaterialInput.of(Rgb.BLACK);
    }
    // A factor of 0 is not meant, even if the picture is missing.
    boolean isBlackMeant = !isMapped;
    double most = key.equals("ke") ? Double.MAX_VALUE : 1;
    Rgb factor =
        in.color(key)
            .map(color -> limited(key, color, most))
            .filter(color -> isBlackMeant || !color.isBlack())
            .orElse(map.isPresent() ? Rgb.WHITE : otherwise);
    return map.isEmpty()
        ? MaterialInput.of(factor)
        : new MaterialInput(factor, Optional.of(textures.texture(map.get())), 0);
  }

  private MaterialInput scalar(MaterialParameter parameter, double otherwise)
      throws ModelFormatException, IOException {
    Optional<MtlMap> map = map("map_" + parameter.mtl());
    double stated = in.number(parameter.mtl()).orElse(map.isPresent() ? 1 : otherwise);
    double factor = limited(parameter.mtl(), stated, parameter.least(), parameter.most());
    if (map.isEmpty()) {
      return MaterialInput.of(factor);
    }
    return new MaterialInput(
        Rgb.gray(factor == 0 ? 1 : factor),
        Optional.of(textures.texture(map.get())),
        Math.max(0, map.get().channel()));
  }

  /**
   * Returns the texture of the first of some keys that has one; empty if its picture is missing.
   */
  private Optional<MtlMap> map(String... keys) throws ModelFormatException, IOException {
    Optional<MtlMap> map = in.map(keys);
    return map.isPresent() && textures.isReadable(map.get(), warnings) ? map : Optional.empty();
  }
}
