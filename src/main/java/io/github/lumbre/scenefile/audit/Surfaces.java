package io.github.lumbre.scenefile.audit;

import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Iterates over a scene's materials and over texture coordinates. */
final class Surfaces {
  /** The number of sampled points per side of the texture. */
  private static final int GRID = 48;

  private Surfaces() {}

  /** A material and its place in the file. */
  record Used(Origin origin, Material material) {}

  /** Returns the distinct materials in use, each with its place in the file. */
  static List<Used> materials(ParsedScene file) {
    Set<Material> known = new HashSet<>();
    List<Used> used = new ArrayList<>();
    for (int i = 0; i < file.scene().primitives().size(); i++) {
      Primitive primitive = file.scene().primitives().get(i);
      if (primitive.emission().isEmpty() && known.add(primitive.material())) {
        used.add(new Used(file.origins().materials().get(i), primitive.material()));
      }
    }
    return used;
  }

  /** Returns a material without its normal map. */
  static Material flat(Material material) {
    return material instanceof NormalMapped mapped ? flat(mapped.material()) : material;
  }

  /** Visits a regular grid of points in the unit square, in texture coordinates. */
  static void forTexturePoints(Consumer<TexturePoint> visitor) {
    for (int i = 0; i < GRID * GRID; i++) {
      visitor.accept(
          new TexturePoint((i % GRID + .5) / GRID, (Math.floorDiv(i, GRID) + .5) / GRID));
    }
  }

  /** Returns the number of points that {@link #forTexturePoints} visits. */
  static int texturePoints() {
    return GRID * GRID;
  }
}
