package io.github.lumbre.audit;

import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.parser.Origin;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Ways through a scene's surfaces. */
final class Surfaces {
  /** Points a side at which textures are looked at. */
  private static final int GRID = 48;

  private Surfaces() {}

  /** A material and where it stands. */
  record Used(Origin origin, Material material) {}

  /** Returns the materials in use, each once, with the place of the first object that has it. */
  static List<Used> materials(SceneFile file) {
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

  /** Returns what a material is below its normal map. */
  static Material flat(Material material) {
    return material instanceof NormalMapped mapped ? flat(mapped.material()) : material;
  }

  /** Visits points spread evenly over the unit square. */
  static void forTexturePoints(Consumer<TexturePoint> visitor) {
    for (int i = 0; i < GRID * GRID; i++) {
      visitor.accept(
          new TexturePoint((i % GRID + .5) / GRID, (Math.floorDiv(i, GRID) + .5) / GRID));
    }
  }

  /** Returns how many points are visited. */
  static int texturePoints() {
    return GRID * GRID;
  }
}
