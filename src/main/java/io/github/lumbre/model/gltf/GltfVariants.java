package io.github.lumbre.model.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.GltfText;
import io.github.lumbre.text.PrintableText;
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
    chosen = wanted.isPresent() ? names.indexOf(wanted.get()) : -1;
    if (wanted.isPresent() && chosen < 0) {
      throw new ModelFormatException(
          Kind.MALFORMED,
          "extensions." + NAME + ".variants",
          names.isEmpty()
              ? "expected a variant "
                  + PrintableText.quoted(wanted.get())
                  + ", found none in the model"
              : "expected "
                  + GltfText.choice(names)
                  + ", found "
                  + PrintableText.quoted(wanted.get()));
    }
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
