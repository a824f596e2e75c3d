package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Warnings;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The JSON of a glTF file by sections, and what all its readers share. Mutable. */
final class GltfDocument {
  private final GltfJson root;
  private final GltfBudget budget;
  private final Warnings warnings = new Warnings();
  private final Map<String, List<GltfJson>> sections = new HashMap<>();

  GltfDocument(GltfJson root, GltfBudget budget) {
    this.root = root;
    this.budget = budget;
  }

  /** Returns the outermost object. */
  GltfJson root() {
    return root;
  }

  /** Returns the limits of the file. */
  GltfBudget budget() {
    return budget;
  }

  /** Returns the warnings so far. */
  Warnings warnings() {
    return warnings;
  }

  /** Returns a list of the file, such as {@code nodes}; empty if the file has none. */
  List<GltfJson> section(String name) throws ModelFormatException {
    List<GltfJson> section = sections.get(name);
    if (section == null) {
      section = root.objects(name);
      sections.put(name, section);
    }
    return section;
  }

  /** Returns an index into a section that an object has as a member, and that must exist. */
  int requireIndex(GltfJson object, String member, String section) throws ModelFormatException {
    return object.requireIndex(member, section(section).size());
  }

  /** Returns the number of items of a section. */
  int size(String section) throws ModelFormatException {
    return section(section).size();
  }
}
