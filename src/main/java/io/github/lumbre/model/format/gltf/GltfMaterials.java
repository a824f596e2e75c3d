package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PlainModel;
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

  private static final String CORE = MaterialParameter.BASE_COLOR.gltfObject();

  /** The largest reflectance head-on of a material that is not metallic. */
  private static final double MAX_DIELECTRIC = .3;

  private static final List<String> ALPHA_MODES = List.of("OPAQUE", "MASK", "BLEND");

  private final GltfDocument document;
  private final GltfTextures textures;
  private final GltfValues values;
  private final ModelMaterial standard = ModelMaterial.builder("", "").build();
  private final Map<Integer, ModelMaterial> materials = new HashMap<>();
  private final Map<ModelMaterial, ModelMaterial> ofPoints = new IdentityHashMap<>();

  GltfMaterials(GltfDocument document, GltfTextures textures) {
    this.document = document;
    this.textures = textures;
    values = new GltfValues(document.warnings(), "material");
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
    boolean isUnlit = values.extension(json, UNLIT).isPresent();
    ModelMaterial.Builder material =
        ModelMaterial.builder(values.name(json), json.location())
            .normalMap(normals(json, "normalTexture", bumps))
            .alphaMode(
                AlphaMode.valueOf(values.choice(json, "alphaMode", ALPHA_MODES, "OPAQUE")))
            .alphaCutoff(values.upTo(Double.MAX_VALUE, json, "alphaCutoff", .5))
            .doubleSided(values.flag(json, "doubleSided", false))
            .unlit(isUnlit)
            .emission(emission(json));
    Optional<GltfJson> glossy =
        isUnlit ? Optional.empty() : values.extension(json, GLOSSY);
    boolean isGlossy = glossy.isPresent() && isGlossy(json, glossy.get());
    Optional<GltfJson> core = values.object(json, CORE);
    if (isGlossy) {
      readGlossy(glossy.get(), material);
    } else if (core.isPresent()) {
      readParameters(core.get(), CORE, material);
    }
    for (String name : MaterialParameter.gltfExtensions()) {
      Optional<GltfJson> found = values.extension(json, name);
      if (found.isPresent() && isGlossy) {
        warn(
            "an extension of a material is left out",
            found.get().location(),
            "has no effect beside " + GLOSSY);
      } else if (found.isPresent() && isValid(name, found.get())) {
        readParameters(found.get(), name, material);
      }
    }
    return material.build();
  }

  /**
   * Returns whether specular-glossiness counts; warns if there is metallic-roughness, too. That
   * counts if it has a texture of base color, or is a dielectric that cannot reflect as much as the
   * extension states: converters such as assimp up to version 5.2 write the same colors into both,
   * with a reflectance that they do not mean.
   */
  private boolean isGlossy(GltfJson json, GltfJson glossy)
      throws ModelFormatException, IOException {
    Optional<GltfJson> found = values.object(json, CORE);
    if (found.isEmpty() || found.get().keys().isEmpty()) {
      return true;
    }
    GltfJson core = found.get();
    double[] specular = values.color(1, glossy, "specularFactor", 1, 1, 1);
    boolean isTooBright =
        !glossy.has("specularGlossinessTexture")
            && Math.max(specular[0], Math.max(specular[1], specular[2])) > MAX_DIELECTRIC
            && values.upTo(1, core, "metallicFactor", 1) == 0;
    boolean isCore = isTooBright || textures.read(core, "baseColorTexture").isPresent();
    warn(
        "a material is described twice",
        isCore ? glossy.location() : core.location(),
        "has no effect beside " + (isCore ? CORE : GLOSSY));
    return !isCore;
  }

  private void readGlossy(GltfJson json, ModelMaterial.Builder out)
      throws ModelFormatException, IOException {
    double[] color = values.color(1, json, "diffuseFactor", 1, 1, 1, 1);
    double opacity = opacity(json, "diffuseFactor", color);
    Optional<ModelTexture> diffuse = textures.read(json, "diffuseTexture");
    double[] f0 = values.color(1, json, "specularFactor", 1, 1, 1);
    double glossiness = values.upTo(1, json, "glossinessFactor", 1);
    Optional<ModelTexture> specular = textures.read(json, "specularGlossinessTexture");
    // With the index 0, the specular color alone is the reflectance (KHR_materials_ior).
    out.glossy(true)
        .set(MaterialParameter.BASE_COLOR, new MaterialInput(rgb(color), diffuse, 0))
        .set(MaterialParameter.OPACITY, new MaterialInput(Rgb.gray(opacity), diffuse, 3))
        .set(MaterialParameter.METALLIC, 0)
        .set(MaterialParameter.IOR, 0)
        .set(MaterialParameter.SPECULAR_COLOR, new MaterialInput(rgb(f0), specular, 0))
        .set(MaterialParameter.ROUGHNESS, new MaterialInput(Rgb.gray(glossiness), specular, 3));
  }

  /** Returns whether the parameters of an object count: a volume needs a thickness. */
  private boolean isValid(String name, GltfJson json) {
    return !name.equals(MaterialParameter.VOLUME_EXTENSION)
        || values.upTo(Double.MAX_VALUE, json, "thicknessFactor", 0) > 0;
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
      GltfJson json, MaterialParameter parameter, Optional<ModelTexture> texture) {
    return switch (parameter.kind()) {
      case NORMALS -> normals(json, parameter.gltfTexture(), texture);
      case COLOR -> Optional.of(new MaterialInput(rgb(json, parameter), texture, 0));
      case NUMBER ->
          Optional.of(
              new MaterialInput(
                  Rgb.gray(number(json, parameter)), texture, parameter.gltfChannel()));
    };
  }

  private MaterialInput emission(GltfJson json) throws ModelFormatException, IOException {
    double[] factor = values.color(Double.MAX_VALUE, json, "emissiveFactor", 0, 0, 0);
    Optional<ModelTexture> texture = textures.read(json, "emissiveTexture");
    // Without its texture, a surface would glow all over.
    boolean isLost = json.has("emissiveTexture") && texture.isEmpty();
    Rgb radiance = isLost ? Rgb.BLACK : rgb(factor).times(strength(json, rgb(factor)));
    return new MaterialInput(radiance, texture, 0);
  }

  /** Returns the strength of an emission; 1 if the radiance would be infinite. */
  private double strength(GltfJson json, Rgb factor) {
    Optional<GltfJson> extension = values.extension(json, "KHR_materials_emissive_strength");
    if (extension.isEmpty()) {
      return 1;
    }
    double strength = values.upTo(Double.MAX_VALUE, extension.get(), "emissiveStrength", 1);
    if (factor.times(strength).isFinite()) {
      return strength;
    }
    String location = extension.get().location("emissiveStrength");
    values.replaced(location, "a finite radiance", PrintableText.number(strength), "1");
    return 1;
  }

  private Optional<MaterialInput> normals(
      GltfJson json, String member, Optional<ModelTexture> texture) {
    double scale =
        values.object(json, member).map(info -> values.number(info, "scale", 1)).orElse(1.);
    return texture.map(map -> new MaterialInput(Rgb.gray(scale), Optional.of(map), 0));
  }

  private double number(GltfJson json, MaterialParameter parameter) {
    String member = parameter.gltfFactor();
    double missing = parameter.defaultValue().r();
    if (parameter == MaterialParameter.OPACITY) {
      return opacity(json, member, values.numbers(json, member, 1, 1, 1, 1));
    }
    if (member.isEmpty()) {
      return missing;
    }
    if (parameter.most() > Double.MAX_VALUE) {
      return values.positive(json, member, "infinity").orElse(missing);
    }
    double value = values.number(json, member, missing) * parameter.gltfUnit();
    return parameter.accepts(value)
        ? value
        : values.clamped(
            json.location(member), value, parameter.least(), parameter.most(), expected(parameter));
  }

  private static String expected(MaterialParameter parameter) {
    return parameter.least() < 0 ? "an angle" : parameter.expected();
  }

  private double opacity(GltfJson json, String member, double... color) {
    return values.clamped(json.location(member), color[3], 0, 1, "0 to 1");
  }

  private Rgb rgb(GltfJson json, MaterialParameter parameter) {
    Rgb missing = parameter.defaultValue();
    double[] fallback =
        parameter == MaterialParameter.BASE_COLOR
            ? new double[] {1, 1, 1, 1}
            : new double[] {missing.r(), missing.g(), missing.b()};
    return rgb(values.color(parameter.most(), json, parameter.gltfFactor(), fallback));
  }

  private static Rgb rgb(double... c) {
    return new Rgb(c[0], c[1], c[2]);
  }

  private void warn(String kind, String location, String message) {
    document.warnings().add(kind, location, message);
  }
}
