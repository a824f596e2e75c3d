package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelNames;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** The material variants of a glTF file (KHR_materials_variants). Immutable. */
final class GltfVariants {
  private static final String NAME = "KHR_materials_variants";

  private final GltfDocument document;
  private final List<String> names = new ArrayList<>();
  private final int chosen;

  /**
   * @param wanted name of the variant to use; empty for the default materials
   * @throws ModelFormatException if the file has no such variant
   */
  GltfVariants(GltfDocument document, Optional<String> wanted) throws ModelFormatException {
    this.document = document;
    Optional<GltfJson> extension = document.root().extension(NAME);
    if (extension.isPresent()) {
      for (GltfJson variant : extension.get().objects("variants")) {
        names.add(variant.text("name", Integer.toString(names.size())));
      }
    }
    chosen =
        wanted.isPresent()
            ? ModelNames.index("extensions." + NAME + ".variants", "a variant", names, wanted.get())
            : -1;
  }

  /** Returns the names of all variants; the index of one that has no name. */
  List<String> names() {
    return names;
  }

  /** Returns the index of a primitive's material; empty for the default one. */
  OptionalInt material(GltfJson primitive) throws ModelFormatException {
    int materials = document.size("materials");
    Optional<GltfJson> extension = primitive.extension(NAME);
    if (chosen >= 0 && extension.isPresent()) {
      for (GltfJson mapping : extension.get().objects("mappings")) {
        for (int variant : mapping.indices("variants", names.size())) {
          if (variant == chosen) {
            return OptionalInt.of(mapping.requireIndex("material", materials));
          }
        }
      }
    }
    return primitive.index("material", materials);
  }
}
