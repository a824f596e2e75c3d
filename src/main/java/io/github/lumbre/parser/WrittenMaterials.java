package io.github.lumbre.parser;

import com.google.gson.JsonObject;
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
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.internal.SceneNode;
import java.util.Optional;

/** Writes materials. */
record WrittenMaterials(WrittenAssets assets, WrittenTextures textures) {
  private static final double MAX_IOR = MaterialReader.MAX_IOR;

  /**
   * Writes the material of a surface and returns its id.
   *
   * @param name of the material in the scene
   */
  int id(SceneNode.Surface surface, String name) {
    Optional<Emission> emission = surface.emission();
    if (emission.isEmpty()) {
      return assets.id(
          surface.material(), name, "Material", to -> material(to, name, surface.material()));
    }
    if (surface.material() != Unlit.INSTANCE) {
      throw new Unwritable(
          "a surface that scatters or emits light", "one that does both; use two surfaces");
    }
    String variant = surface.isDeclared() + name;
    return assets.id(
        emission.get(),
        variant,
        "Material",
        to -> emission(to, name, emission.get(), surface.isDeclared()));
  }

  private void emission(JsonObject to, String name, Emission emission, boolean isDeclared) {
    to.addProperty("name", name);
    if (isDeclared) {
      to.addProperty("materialType", "AreaLight");
      to.addProperty("twoSided", emission.twoSided());
    } else if (emission.twoSided()) {
      to.addProperty("materialType", "Color");
    } else {
      throw new Unwritable(
          "an emissive surface that emits on both sides",
          "one that emits outside; use addAreaLight");
    }
    if (emission.meanRadiance() != new Emission(emission.radiance(), true).meanRadiance()) {
      throw new Unwritable("the mean radiance of the texture", "another one");
    }
    textures.color(to, "color", emission.radiance());
  }

  private void material(JsonObject to, String name, Material material) {
    to.addProperty("name", name);
    if (material instanceof NormalMapped mapped) {
      if (mapped.uvSet() != 0 || mapped.material() instanceof NormalMapped) {
        throw new Unwritable("one normal map with the first texture coordinates", "another one");
      }
      flat(to, mapped.material());
      if (mapped.material() instanceof ShadowCatcher) {
        throw new Unwritable("a shadow catcher without a normal map", "one with a normal map");
      }
      textures.normalMap(to, "normal", mapped.map());
    } else {
      flat(to, material);
    }
  }

  private void flat(JsonObject to, Material material) {
    if (material instanceof Matte matte) {
      to.addProperty("materialType", "Diffuse");
      textures.color(to, "color", matte.albedo());
    } else if (material instanceof ShadowCatcher catcher) {
      to.addProperty("materialType", "ShadowCatcher");
      textures.color(to, "color", catcher.surface().albedo());
    } else if (material instanceof Mirror mirror) {
      to.addProperty("materialType", "Reflective");
      textures.color(to, "reflectivityColor", mirror.reflectance());
    } else if (material instanceof Glass glass) {
      glass(to, glass);
    } else if (material instanceof Phong phong) {
      to.addProperty("materialType", "Phong");
      textures.color(to, "color", phong.diffuse());
      textures.color(to, "specularColor", phong.specular());
      textures.scalar(
          to, "exponent", phong.exponent(), Range.NOT_NEGATIVE, 0, Double.MAX_VALUE);
    } else if (material instanceof CookTorrance glossy) {
      cookTorrance(to, glossy);
    } else if (material instanceof MetallicRoughness layered) {
      metallicRoughness(to, layered);
    } else {
      throw new Unwritable("a material of the format", Written.name(material));
    }
  }

  private void glass(JsonObject to, Glass glass) {
    to.addProperty("materialType", "Refractive");
    textures.color(to, "reflectivityColor", glass.reflectance());
    textures.color(to, "refractionColor", glass.transmittance());
    textures.scalar(to, "ior", glass.ior(), Dielectric.IOR, 1, MAX_IOR);
    textures.scalar(to, "roughness", glass.roughness(), Range.FRACTION, 0, 1);
    multipleScattering(to, glass.multipleScattering());
  }

  private void cookTorrance(JsonObject to, CookTorrance glossy) {
    to.addProperty("materialType", "CookTorrance");
    textures.color(to, "color", glossy.diffuse());
    textures.color(to, "specularColor", glossy.specular());
    textures.scalar(to, "roughness", glossy.roughness(), Range.FRACTION, 0, 1);
    textures.scalar(to, "ior", glossy.ior(), Dielectric.IOR, 1, MAX_IOR);
    boolean isGgx = glossy.distribution() == MicrofacetDistribution.GGX;
    to.addProperty("distribution", isGgx ? "ggx" : "beckmann");
    multipleScattering(to, glossy.multipleScattering());
  }

  private static void multipleScattering(JsonObject to, boolean isStated) {
    if (isStated) {
      to.addProperty("multipleScattering", true);
    }
  }

  private void metallicRoughness(JsonObject to, MetallicRoughness material) {
    to.addProperty("materialType", "MetallicRoughness");
    for (MaterialParameter parameter : MaterialParameter.all()) {
      material.stated(parameter).ifPresent(value -> parameter(to, parameter, value));
    }
    if (!material.isDoubleSided()) {
      to.addProperty("twoSided", false);
    }
  }

  private void parameter(JsonObject to, MaterialParameter parameter, Channel value) {
    String key = parameter.key();
    if (value instanceof ColorChannel.Textured color && color.uvSet() == 0) {
      textures.color(to, key, color.texture());
    } else if (value instanceof ScalarChannel.Textured number && number.uvSet() == 0) {
      textures.scalar(
          to,
          key,
          number.texture(),
          MaterialReader.range(parameter),
          parameter.least(),
          parameter.most());
    } else if (value instanceof NormalChannel normals && normals.uvSet() == 0) {
      textures.normalMap(to, key, normals.map());
    } else {
      throw new Unwritable(
          key + ": a texture with the first texture coordinates", Written.name(value));
    }
  }
}
