package io.github.lumbre.model;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelMaterial.AlphaMode;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The materials of a glTF file: glTF 2.0, section 3.9, and the extensions KHR_materials_*. Mutable:
 * each material is built once.
 */
final class GltfMaterials {
  private static final int RED = 0;
  private static final int GREEN = 1;
  private static final int BLUE = 2;
  private static final int ALPHA = 3;

  private final GltfDocument document;
  private final GltfTextures textures;
  private final ModelMaterial standard = ModelMaterial.builder("", "").build();
  private final Map<Integer, ModelMaterial> materials = new HashMap<>();

  GltfMaterials(GltfDocument document, GltfTextures textures) {
    this.document = document;
    this.textures = textures;
  }

  /** Returns a material; the default one for none. */
  ModelMaterial get(OptionalInt index) throws ModelFormatException, IOException {
    if (index.isEmpty()) {
      return standard;
    }
    ModelMaterial material = materials.get(index.getAsInt());
    if (material == null) {
      material = read(document.section("materials").get(index.getAsInt()));
      materials.put(index.getAsInt(), material);
    }
    return material;
  }

  private ModelMaterial read(GltfJson json) throws ModelFormatException, IOException {
    ModelMaterial.Builder material =
        ModelMaterial.builder(json.text("name", ""), json.location())
            .normalMap(normal(json, "normalTexture"))
            .alphaMode(
                AlphaMode.valueOf(
                    json.choice("alphaMode", "OPAQUE", List.of("OPAQUE", "MASK", "BLEND"))))
            .alphaCutoff(json.number("alphaCutoff", .5))
            .doubleSided(json.flag("doubleSided", false))
            .unlit(json.extension("KHR_materials_unlit").isPresent());
    readMetallicRoughness(json, material);
    readEmission(json, material);
    readDielectric(json, material);
    readTransmission(json, material);
    readLayers(json, material);
    return material.build();
  }

  private void readMetallicRoughness(GltfJson material, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Optional<GltfJson> found = material.object("pbrMetallicRoughness");
    if (found.isEmpty()) {
      return;
    }
    GltfJson json = found.get();
    double[] factor = json.numbers("baseColorFactor", 1, 1, 1, 1);
    for (int i = 0; i < factor.length; i++) {
      factor[i] = clamped(json, "baseColorFactor", factor[i], 1);
    }
    Optional<ModelTexture> texture = textures.read(json, "baseColorTexture");
    out.baseColor(new ColorInput(new Rgb(factor[0], factor[1], factor[2]), texture));
    out.opacity(new ScalarInput(factor[3], texture, ALPHA));
    Optional<ModelTexture> both = textures.read(json, "metallicRoughnessTexture");
    out.metallic(new ScalarInput(fraction(json, "metallicFactor", 1), both, BLUE));
    out.roughness(new ScalarInput(fraction(json, "roughnessFactor", 1), both, GREEN));
  }

  private void readEmission(GltfJson json, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Optional<GltfJson> extension = json.extension("KHR_materials_emissive_strength");
    double strength =
        extension.isPresent() ? atLeastZero(extension.get(), "emissiveStrength", 1) : 1;
    ColorInput plain = color(json, "emissiveFactor", "emissiveTexture", Rgb.BLACK, false);
    // Without its texture, a surface would glow all over.
    boolean isLost = json.has("emissiveTexture") && plain.texture().isEmpty();
    Rgb radiance = isLost ? Rgb.BLACK : plain.factor().times(strength);
    if (!radiance.isFinite()) {
      throw json.malformed("emissiveFactor", "expected a finite radiance, found an infinite one");
    }
    out.emission(new ColorInput(radiance, plain.texture()));
  }

  private void readDielectric(GltfJson material, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Optional<GltfJson> ior = material.extension("KHR_materials_ior");
    if (ior.isPresent()) {
      double value = ior.get().number("ior", 1.5);
      if (value != 0 && !(value >= 1)) {
        throw ior.get().expected("ior", "0 or at least 1");
      }
      out.ior(value);
    }
    Optional<GltfJson> specular = material.extension("KHR_materials_specular");
    if (specular.isPresent()) {
      GltfJson json = specular.get();
      out.specular(scalar(json, "specularFactor", 1, "specularTexture", ALPHA));
      out.specularColor(
          color(json, "specularColorFactor", "specularColorTexture", Rgb.WHITE, false));
    }
  }

  private void readTransmission(GltfJson material, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Optional<GltfJson> transmission = material.extension("KHR_materials_transmission");
    if (transmission.isPresent()) {
      GltfJson json = transmission.get();
      out.transmission(scalar(json, "transmissionFactor", 0, "transmissionTexture", RED));
    }
    Optional<GltfJson> volume = material.extension("KHR_materials_volume");
    if (volume.isPresent() && atLeastZero(volume.get(), "thicknessFactor", 0) > 0) {
      GltfJson json = volume.get();
      double distance =
          json.has("attenuationDistance")
              ? json.requirePositive("attenuationDistance")
              : Double.POSITIVE_INFINITY;
      Rgb color = rgb(json, "attenuationColor", Rgb.WHITE, true);
      out.volume(Optional.of(new ModelMaterial.Volume(distance, color)));
    }
  }

  private void readLayers(GltfJson material, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Optional<GltfJson> coat = material.extension("KHR_materials_clearcoat");
    if (coat.isPresent()) {
      GltfJson json = coat.get();
      out.clearcoat(scalar(json, "clearcoatFactor", 0, "clearcoatTexture", RED));
      out.clearcoatRoughness(
          scalar(json, "clearcoatRoughnessFactor", 0, "clearcoatRoughnessTexture", GREEN));
      out.clearcoatNormalMap(normal(json, "clearcoatNormalTexture"));
    }
    Optional<GltfJson> sheen = material.extension("KHR_materials_sheen");
    if (sheen.isPresent()) {
      GltfJson json = sheen.get();
      out.sheenColor(color(json, "sheenColorFactor", "sheenColorTexture", Rgb.BLACK, true));
      out.sheenRoughness(scalar(json, "sheenRoughnessFactor", 0, "sheenRoughnessTexture", ALPHA));
    }
  }

  private Optional<NormalInput> normal(GltfJson json, String member)
      throws ModelFormatException, IOException {
    Optional<ModelTexture> texture = textures.read(json, member);
    return texture.isPresent()
        ? Optional.of(new NormalInput(texture.get(), json.requireObject(member).number("scale", 1)))
        : Optional.empty();
  }

  private ScalarInput scalar(
      GltfJson json, String factor, double fallback, String texture, int channel)
      throws ModelFormatException, IOException {
    return new ScalarInput(fraction(json, factor, fallback), textures.read(json, texture), channel);
  }

  private ColorInput color(
      GltfJson json, String factor, String texture, Rgb fallback, boolean isFraction)
      throws ModelFormatException, IOException {
    return new ColorInput(rgb(json, factor, fallback, isFraction), textures.read(json, texture));
  }

  private Rgb rgb(GltfJson json, String member, Rgb fallback, boolean isFraction)
      throws ModelFormatException {
    double[] c = json.numbers(member, fallback.r(), fallback.g(), fallback.b());
    for (int i = 0; i < 3; i++) {
      c[i] = clamped(json, member, c[i], isFraction ? 1 : Double.MAX_VALUE);
    }
    return new Rgb(c[0], c[1], c[2]);
  }

  private double fraction(GltfJson json, String member, double fallback)
      throws ModelFormatException {
    return clamped(json, member, json.number(member, fallback), 1);
  }

  private double atLeastZero(GltfJson json, String member, double fallback)
      throws ModelFormatException {
    return clamped(json, member, json.number(member, fallback), Double.MAX_VALUE);
  }

  private double clamped(GltfJson json, String member, double value, double max) {
    double clamped = Math.max(0, Math.min(value, max));
    if (clamped != value) {
      document
          .warnings()
          .add(
              "a number of a material is out of range",
              json.location(member),
              "expected "
                  + (max == 1 ? "0 to 1" : "at least 0")
                  + ", found "
                  + GltfText.number(value)
                  + "; "
                  + GltfText.number(clamped)
                  + " is used");
    }
    return clamped;
  }
}
