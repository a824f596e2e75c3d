package io.github.lumbre.model.gltf;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.text.PrintableText;
import java.io.IOException;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The materials of a glTF file: glTF 2.0, section 3.9, and the extensions KHR_materials_*. Mutable:
 * each material is built once.
 */
final class GltfMaterials {
  /** An extension whose parameters replace those of all others that have parameters. */
  static final String GLOSSY = "KHR_materials_pbrSpecularGlossiness";

  /** An extension that replaces {@link #GLOSSY}, too. */
  static final String UNLIT = "KHR_materials_unlit";

  private final GltfDocument document;
  private final GltfTextures textures;
  private final ModelMaterial standard = ModelMaterial.builder("", "").build();
  private final Map<Integer, ModelMaterial> materials = new HashMap<>();
  private final Map<ModelMaterial, ModelMaterial> ofPoints = new IdentityHashMap<>();

  GltfMaterials(GltfDocument document, GltfTextures textures) {
    this.document = document;
    this.textures = textures;
  }

  /**
   * Returns a material; the default one for none.
   *
   * @param isOfPoints whether points have it: they show its base color, diffusely, and its
   *     emission, as clients without lighting do (glTF 2.0, section 3.9.6)
   */
  ModelMaterial get(OptionalInt index, boolean isOfPoints)
      throws ModelFormatException, IOException {
    ModelMaterial material = get(index);
    return isOfPoints ? ofPoints.computeIfAbsent(material, GltfMaterials::ofPoints) : material;
  }

  private static ModelMaterial ofPoints(ModelMaterial material) {
    return PlainModel.matte(material.name(), material.location())
        .set(MaterialParameter.BASE_COLOR, material.input(MaterialParameter.BASE_COLOR))
        .set(MaterialParameter.OPACITY, material.input(MaterialParameter.OPACITY))
        .emission(material.emission())
        .alphaMode(material.alphaMode())
        .alphaCutoff(material.alphaCutoff())
        .unlit(material.unlit())
        .build();
  }

  private ModelMaterial get(OptionalInt index) throws ModelFormatException, IOException {
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
    Optional<ModelTexture> bumps = textures.read(json, "normalTexture");
    ModelMaterial.Builder material =
        ModelMaterial.builder(json.text("name", ""), json.location())
            .normalMap(bumps.isPresent() ? normals(json, "normalTexture", bumps) : Optional.empty())
            .alphaMode(
                AlphaMode.valueOf(
                    json.choice("alphaMode", "OPAQUE", List.of("OPAQUE", "MASK", "BLEND"))))
            .alphaCutoff(json.number("alphaCutoff", .5))
            .doubleSided(json.flag("doubleSided", false))
            .unlit(json.extension(UNLIT).isPresent())
            .emission(emission(json));
    Optional<GltfJson> glossy = json.extension(GLOSSY);
    boolean isGlossy = glossy.isPresent() && json.extension(UNLIT).isEmpty();
    if (isGlossy) {
      readGlossy(glossy.get(), material);
    }
    for (String name : MaterialParameter.gltfObjects()) {
      boolean isExtension = name.startsWith("KHR_");
      Optional<GltfJson> found = isExtension ? json.extension(name) : json.object(name);
      if (found.isPresent() && isGlossy && isExtension) {
        warn(
            "an extension of a material is left out",
            found.get().location(),
            "has no effect beside " + GLOSSY);
      } else if (found.isPresent() && !isGlossy && isValid(name, found.get())) {
        readParameters(found.get(), name, material);
      }
    }
    return material.build();
  }

  private void readGlossy(GltfJson json, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    double[] color = clamped(json, "diffuseFactor", 1, 1, 1, 1, 1);
    double opacity = clamped(json, "diffuseFactor", color[3], 1);
    Optional<ModelTexture> diffuse = textures.read(json, "diffuseTexture");
    double[] f0 = clamped(json, "specularFactor", 1, 1, 1, 1);
    double glossiness = clamped(json, "glossinessFactor", json.number("glossinessFactor", 1), 1);
    Optional<ModelTexture> specular = textures.read(json, "specularGlossinessTexture");
    // With the index 0, the specular color alone is the reflectance (KHR_materials_ior).
    out.glossy(true)
        .set(MaterialParameter.BASE_COLOR, new MaterialInput(rgb(color), diffuse, 0))
        .set(MaterialParameter.OPACITY, new MaterialInput(Rgb.grey(opacity), diffuse, 3))
        .set(MaterialParameter.METALLIC, 0)
        .set(MaterialParameter.IOR, 0)
        .set(MaterialParameter.SPECULAR_COLOR, new MaterialInput(rgb(f0), specular, 0))
        .set(MaterialParameter.ROUGHNESS, new MaterialInput(Rgb.grey(glossiness), specular, 3));
  }

  /** Returns whether the parameters of an object count: a volume needs a thickness. */
  private boolean isValid(String name, GltfJson json) throws ModelFormatException {
    return !name.equals(MaterialParameter.VOLUME_EXTENSION)
        || clamped(json, "thicknessFactor", json.number("thicknessFactor", 0), Double.MAX_VALUE)
            > 0;
  }

  private void readParameters(GltfJson json, String object, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    Map<String, Optional<ModelTexture>> read = new HashMap<>();
    for (MaterialParameter parameter : MaterialParameter.all()) {
      if (parameter.gltfObject().equals(object)) {
        String member = parameter.gltfTexture();
        if (!read.containsKey(member)) {
          read.put(member, textures.read(json, member));
        }
        Optional<MaterialInput> value = input(json, parameter, read.get(member));
        value.ifPresent(input -> out.set(parameter, input));
      }
    }
  }

  private Optional<MaterialInput> input(
      GltfJson json, MaterialParameter parameter, Optional<ModelTexture> texture)
      throws ModelFormatException {
    return switch (parameter.kind()) {
      case NORMALS -> normals(json, parameter.gltfTexture(), texture);
      case COLOR -> Optional.of(new MaterialInput(rgb(json, parameter), texture, 0));
      case NUMBER ->
          Optional.of(
              new MaterialInput(
                  Rgb.grey(number(json, parameter)), texture, parameter.gltfChannel()));
    };
  }

  private MaterialInput emission(GltfJson json) throws ModelFormatException, IOException {
    Optional<GltfJson> extension = json.extension("KHR_materials_emissive_strength");
    double strength = 1;
    if (extension.isPresent()) {
      double stated = extension.get().number("emissiveStrength", 1);
      strength = clamped(extension.get(), "emissiveStrength", stated, Double.MAX_VALUE);
    }
    double[] factor = clamped(json, "emissiveFactor", Double.MAX_VALUE, 0, 0, 0);
    Optional<ModelTexture> texture = textures.read(json, "emissiveTexture");
    // Without its texture, a surface would glow all over.
    boolean isLost = json.has("emissiveTexture") && texture.isEmpty();
    Rgb radiance = isLost ? Rgb.BLACK : new Rgb(factor[0], factor[1], factor[2]).times(strength);
    if (!radiance.isFinite()) {
      throw json.malformed("emissiveFactor", "expected a finite radiance, found an infinite one");
    }
    return new MaterialInput(radiance, texture, 0);
  }

  private static Optional<MaterialInput> normals(
      GltfJson json, String member, Optional<ModelTexture> texture) throws ModelFormatException {
    if (texture.isEmpty()) {
      return Optional.empty();
    }
    double scale = json.requireObject(member).number("scale", 1);
    return Optional.of(new MaterialInput(Rgb.grey(scale), texture, 0));
  }

  private double number(GltfJson json, MaterialParameter parameter) throws ModelFormatException {
    String member = parameter.gltfFactor();
    if (parameter == MaterialParameter.OPACITY) {
      return clamped(json, member, json.numbers(member, 1, 1, 1, 1)[3], 1);
    }
    if (member.isEmpty()) {
      return parameter.missing().r();
    }
    double value = json.number(member, parameter.missing().r());
    if (parameter.least() == 0) {
      return clamped(json, member, value, parameter.most());
    }
    if (!parameter.accepts(value)) {
      throw json.expected(member, parameter.expected());
    }
    return value * parameter.gltfUnit();
  }

  private Rgb rgb(GltfJson json, MaterialParameter parameter) throws ModelFormatException {
    Rgb missing = parameter.missing();
    double[] fallback =
        parameter == MaterialParameter.BASE_COLOR
            ? new double[] {1, 1, 1, 1}
            : new double[] {missing.r(), missing.g(), missing.b()};
    return rgb(clamped(json, parameter.gltfFactor(), parameter.most(), fallback));
  }

  private static Rgb rgb(double... c) {
    return new Rgb(c[0], c[1], c[2]);
  }

  /** Returns an array of numbers whose first three are clamped. */
  private double[] clamped(GltfJson json, String member, double max, double... fallback)
      throws ModelFormatException {
    double[] c = json.numbers(member, fallback);
    for (int i = 0; i < 3; i++) {
      c[i] = clamped(json, member, c[i], max);
    }
    return c;
  }

  private double clamped(GltfJson json, String member, double value, double max) {
    double clamped = Math.max(0, Math.min(value, max));
    if (clamped != value) {
      warn(
          "a number of a material is out of range",
          json.location(member),
          "expected %s, found %s; %s is used"
              .formatted(
                  max == 1 ? "0 to 1" : "at least 0",
                  PrintableText.number(value),
                  PrintableText.number(clamped)));
    }
    return clamped;
  }

  private void warn(String kind, String location, String message) {
    document.warnings().add(kind, location, message);
  }
}
