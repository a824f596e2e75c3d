package io.github.lumbre.scenefile;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.scenefile.AssetTable.Type;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads each material at its first use. */
final class MaterialReader {
  private final AssetTable assets;
  private final TextureReader textures;
  private final Map<JsonNode, Surface> surfaces = new HashMap<>();
  private boolean hasGlass;

  MaterialReader(AssetTable assets, TextureReader textures) {
    this.assets = assets;
    this.textures = textures;
  }

  /** Returns the surface for an object's {@code materialID}; the default if it names none. */
  Surface of(JsonNode object) {
    return named(object, ShapeKinds.MATERIAL).orElse(Surface.DEFAULT);
  }

  /** Returns the surface of the material asset with an id that a node states; empty if none. */
  Optional<Surface> named(JsonNode node, Key<Integer> key) {
    return assets
        .find(node, key, Type.MATERIAL)
        .map(asset -> surfaces.computeIfAbsent(asset, this::read));
  }

  /** Returns whether any material in use is glass. */
  boolean hasGlass() {
    return hasGlass;
  }

  private Surface read(JsonNode material) {
    return MaterialKinds.FAMILY
        .choose(material)
        .map(reader -> reader.apply(new Stated(material)))
        .orElse(Surface.DEFAULT);
  }

  /** What an asset states; its methods add errors and warnings at its keys. */
  final class Stated {
    private final JsonNode node;

    private Stated(JsonNode node) {
      this.node = node;
    }

    JsonNode node() {
      return node;
    }

    <T> T get(Key<T> key) {
      return key.in(node);
    }

    ScalarTexture number(Key<Double> key) {
      return textures.number(node, key);
    }

    Texture<Rgb> color(Key<Rgb> key) {
      return textures.color(node, key, get(key));
    }

    Optional<NormalMap> normals(Key<Double> key) {
      return textures.normalMap(node, key);
    }

    /** Returns colors clamped to a reflectance of 1, with at most one warning for all of them. */
    @SafeVarargs
    final List<Texture<Rgb>> reflectances(Key<Rgb>... keys) {
      List<Texture<Rgb>> found = new ArrayList<>();
      boolean isWarned = false;
      for (Key<Rgb> key : keys) {
        Rgb constant = get(key);
        if (constant.max() > 1 && !isWarned) {
          node.warn(key.stem(), "the reflectance exceeds 1; it is clamped to 1");
          isWarned = true;
        }
        found.add(textures.reflectance(node, key, constant));
      }
      return found;
    }

    /** Returns two colors whose sum is a reflectance: at most 1. */
    List<Texture<Rgb>> sum(Key<Rgb> first, Key<Rgb> second) {
      Rgb a = get(first);
      Rgb b = get(second);
      if (a.plus(b).max() > 1) {
        second.warn(
            node,
            "the sum of %s and %s exceeds 1; both are scaled down"
                .formatted(first.name(), second.name()));
      }
      return List.of(textures.color(node, first, a), textures.color(node, second, b));
    }

    /** Returns the surface of a material, with its normal map if it has one. */
    Surface surface(Material flat) {
      hasGlass |=
          flat instanceof Glass
              || flat instanceof MetallicRoughness metal
                  && metal.stated(MaterialParameter.ATTENUATION_DISTANCE).isPresent();
      return Surface.of(
          normals(MaterialKinds.NORMAL)
              .<Material>map(map -> new NormalMapped(flat, map))
              .orElse(flat));
    }
  }
}
