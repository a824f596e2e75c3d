package io.github.lumbre.model.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.scene.internal.Names;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** Hides parts of a model, and highlights others. Confined to one thread. */
public final class PartSelection {
  /** The material of parts beside highlighted ones: paler than that of parts without material. */
  private static final ModelMaterial PALE =
      PlainModel.matte("", "").set(MaterialParameter.BASE_COLOR, Rgb.gray(.85)).build();

  /** The material of highlighted parts if all of them are gray: orange. */
  private static final ModelMaterial ACCENT =
      PlainModel.matte("", "").set(MaterialParameter.BASE_COLOR, new Rgb(.85, .2, .02)).build();

  /** The largest difference of the components of a gray, relative to the largest one. */
  private static final double GRAY = .1;

  /** Shared meshes without colors, by the meshes with colors. */
  private final Map<ModelGeometry, ModelGeometry> colorless = new IdentityHashMap<>();

  private PartSelection() {}

  /** Returns a model in which no two parts have one label. */
  static Model labeled(Model model) {
    Names names = new Names("");
    Map<ModelNode, ModelNode> labeled = new HashMap<>();
    List<ModelPart> all = new ArrayList<>();
    for (ModelPart part : model.parts()) {
      ModelNode node =
          labeled.computeIfAbsent(
              part.node(), n -> n.isDivided() ? n.labeled(names.unused(n.label())) : n);
      all.add(part.with(node, part.geometry(), part.material()));
    }
    return model.with(all);
  }

  /**
   * Returns a model as its options show it.
   *
   * @throws ModelFormatException if it lacks a part that the options name, or nothing is left
   */
  static Model shown(Model model, ModelOptions options) throws ModelFormatException {
    List<String> hide = options.get(ModelOption.HIDE);
    List<String> highlight = options.get(ModelOption.HIGHLIGHT);
    boolean isAll = hide.isEmpty() && highlight.isEmpty();
    if (isAll || model.parts().isEmpty()) {
      return model;
    }
    List<ModelPart> all = PieceModel.of(model).parts();
    Set<ModelNode> hidden = named("hide", hide, all);
    Set<ModelNode> highlighted = named("highlight", highlight, all);
    List<ModelPart> shown = all.stream().filter(part -> !hidden.contains(part.node())).toList();
    if (shown.isEmpty()) {
      throw Kind.MALFORMED.at("hide", "expected at least one part to show, found none");
    }
    return model.with(highlighted.isEmpty() ? shown : painted(shown, highlighted));
  }

  /**
   * Returns a model with the parts that a name means, as of {@link ModelOption#HIDE}; as it is if
   * it has none at all.
   *
   * @param location names the option in messages
   * @throws ModelFormatException if there is none of the name; it lists the names
   */
  public static Model only(Model model, String location, String name) throws ModelFormatException {
    if (model.parts().isEmpty()) {
      return model;
    }
    List<ModelPart> all = PieceModel.of(model).parts();
    Set<ModelNode> meant = named(location, List.of(name), all);
    return model.with(all.stream().filter(part -> meant.contains(part.node())).toList());
  }

  /** Returns highlighted parts as they are, in orange if all of them are gray, and others pale. */
  private static List<ModelPart> painted(List<ModelPart> parts, Set<ModelNode> highlighted) {
    boolean isGray =
        parts.stream()
            .filter(part -> highlighted.contains(part.node()))
            .allMatch(PartSelection::isGray);
    PartSelection selection = new PartSelection();
    List<ModelPart> painted = new ArrayList<>();
    for (ModelPart part : parts) {
      boolean isPale = !highlighted.contains(part.node());
      painted.add(isPale || isGray ? selection.painted(part, isPale ? PALE : ACCENT) : part);
    }
    return painted;
  }

  /**
   * Returns the parts that are named, or belong to a part that is.
   *
   * @throws ModelFormatException if there is none of a name; it lists the names
   */
  private static Set<ModelNode> named(String location, List<String> wanted, List<ModelPart> parts)
      throws ModelFormatException {
    Set<ModelNode> all = new LinkedHashSet<>();
    parts.forEach(part -> all.add(part.node()));
    Set<ModelNode> named = new HashSet<>();
    for (String name : wanted) {
      Predicate<String> isMeant = text -> isMeant(name, text);
      List<ModelNode> found = all.stream().filter(node -> node.matches(isMeant)).toList();
      if (found.isEmpty()) {
        ModelNames.index(location, "a part", labels(all), name);
      }
      named.addAll(found);
    }
    return named;
  }

  /** Returns the labels of parts, then of those that they belong to. */
  private static List<String> labels(Set<ModelNode> parts) {
    Set<String> labels = new LinkedHashSet<>();
    parts.forEach(part -> labels.add(part.label()));
    for (ModelNode part : parts) {
      Optional<ModelNode> above = part.parent();
      while (above.isPresent() && labels.add(above.get().label())) {
        above = above.get().parent();
      }
    }
    return List.copyOf(labels);
  }

  /** Returns whether a text is the wanted one, in which {@code *} stands for any text. */
  public static boolean isMeant(String wanted, String text) {
    if (wanted.equals(text)) {
      return true;
    }
    String[] pieces = wanted.split("\\*", -1);
    int end = text.length() - pieces[pieces.length - 1].length();
    if (pieces.length == 1
        || !text.startsWith(pieces[0])
        || !text.endsWith(pieces[pieces.length - 1])) {
      return false;
    }
    int at = pieces[0].length();
    for (int i = 1; i < pieces.length - 1; i++) {
      at = text.indexOf(pieces[i], at);
      if (at < 0) {
        return false;
      }
      at += pieces[i].length();
    }
    return at <= end;
  }

  /** Returns whether a surface has neither a color nor a texture. */
  private static boolean isGray(ModelPart part) {
    MaterialInput base = part.material().input(MaterialParameter.BASE_COLOR);
    Rgb color = base.factor();
    double least = Math.min(color.r(), Math.min(color.g(), color.b()));
    return base.texture().isEmpty()
        && part.geometry().colors().length == 0
        && color.max() - least <= GRAY * color.max();
  }

  /** Returns whether a material is that of parts beside highlighted ones, perhaps cut. */
  public static boolean isPale(ModelMaterial material) {
    // The place first: linking a record's comparison takes 5 % of a small file's check.
    return material.location().equals(PALE.location())
        && (material.equals(PALE) || material.equals(PALE.fromBothSides()));
  }

  private ModelPart painted(ModelPart part, ModelMaterial look) {
    ModelGeometry geometry = part.geometry();
    return part.with(
        part.node(),
        geometry.colors().length == 0
            ? geometry
            : colorless.computeIfAbsent(geometry, ModelGeometry::withoutColors),
        look);
  }
}
