package io.github.lumbre.model.obj;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.Optional;

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
 *   <li>A picture that is missing is left out with a warning.
 * </ul>
 */
final class MtlConversion {
  /** The reflectance at normal incidence of index 1.5, which is the default. */
  private static final double DEFAULT_REFLECTANCE = .04;

  /** The reflectance at normal incidence of a Ks of 1. */
  private static final double FULL_REFLECTANCE = .08;

  private static final double DEFAULT_SHEEN_ROUGHNESS = .5;

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
    out.set(BASE_COLOR, color("kd", Rgb.grey(PlainModel.ALBEDO)));
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
    return in.number("illum").orElse(2.).intValue();
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
    double scale = (reflects ? 1 : FULL_REFLECTANCE) / DEFAULT_REFLECTANCE;
    out.set(SPECULAR, 1);
    out.set(
        SPECULAR_COLOR, reflectance.withFactor(reflectance.factor().clampedToOne().times(scale)));
    out.set(ROUGHNESS, phongRoughness());
  }

  private double phongRoughness() {
    double exponent = in.number("ns").orElse(0.);
    if (exponent < 0) {
      warnings.add(in.location(), "replaced a negative Ns by 0");
    }
    return Math.sqrt(Math.sqrt(2 / (Math.max(0, exponent) + 2)));
  }

  private void setRefraction() {
    double opacity = opacity();
    out.set(TRANSMISSION, opacity < 1 ? 1 - opacity : 1);
    out.set(BASE_COLOR, in.color("tf").orElse(Rgb.WHITE).clampedToOne());
    out.set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY);
    out.set(SPECULAR, 1);
    out.set(SPECULAR_COLOR, Rgb.WHITE);
    out.set(IOR, ior());
    if (in.number("ns").isEmpty() && in.number("pr").isEmpty()) {
      out.set(ROUGHNESS, 0);
    }
  }

  private double ior() {
    double ior = in.number("ni").orElse(1.5);
    if (!IOR.accepts(ior)) {
      String found = ior < 1 ? "below 1 by 1" : "above 1e6 by 1e6";
      warnings.add(in.location(), "replaced an Ni " + found);
    }
    return Math.max(IOR.least(), Math.min(ior, IOR.most()));
  }

  private double opacity() {
    double opacity = in.number("d").orElseGet(() -> 1 - in.number("tr").orElse(0.));
    return isTrOpacity() ? 1 : Math.max(0, Math.min(opacity, 1));
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
      out.set(OPACITY, new MaterialInput(Rgb.grey(opacity), texture, channel));
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
            Rgb.grey(map.get().bumpScale()), Optional.of(textures.texture(map.get())), 0));
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
    Rgb factor =
        in.color(key)
            .filter(color -> isBlackMeant || !color.isBlack())
            .orElse(map.isPresent() ? Rgb.WHITE : otherwise);
    Rgb limited = key.equals("ke") ? factor : factor.clampedToOne();
    return map.isEmpty()
        ? MaterialInput.of(limited)
        : new MaterialInput(limited, Optional.of(textures.texture(map.get())), 0);
  }

  private MaterialInput scalar(MaterialParameter parameter, double otherwise)
      throws ModelFormatException, IOException {
    Optional<MtlMap> map = map("map_" + parameter.mtl());
    double stated = in.number(parameter.mtl()).orElse(map.isPresent() ? 1 : otherwise);
    double factor = Math.max(parameter.least(), Math.min(stated, parameter.most()));
    if (map.isEmpty()) {
      return MaterialInput.of(factor);
    }
    return new MaterialInput(
        Rgb.grey(factor == 0 ? 1 : factor),
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
