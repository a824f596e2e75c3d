package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * A part of a model as its file divides it: a node, an object, a group or a solid. Surfaces of one
 * part share one object. Immutable; compared by identity.
 */
public final class ModelNode {
  private final String name;
  private final String label;
  private final Optional<ModelNode> parent;

  /** What this is a piece of; empty for itself. */
  private final Optional<ModelNode> whole;

  private ModelNode(
      String name, String label, Optional<ModelNode> parent, Optional<ModelNode> whole) {
    this.name = Objects.requireNonNull(name, "name");
    this.label = Objects.requireNonNull(label, "label");
    this.parent = Objects.requireNonNull(parent, "parent");
    this.whole = Objects.requireNonNull(whole, "whole");
  }

  /**
   * Returns the whole of a file that is not divided; its parts are its connected pieces.
   *
   * @param name in the file; empty if there is none
   */
  public static ModelNode undivided(String name) {
    return new ModelNode(name, "", Optional.empty(), Optional.empty());
  }

  /**
   * Returns a part.
   *
   * @param name in the file; empty if it has none
   * @param otherwise the label of a part without a name, such as {@code node 3}
   * @param parent the part that it belongs to
   */
  public static ModelNode of(String name, String otherwise, Optional<ModelNode> parent) {
    String shown = PrintableText.shortened(name);
    return new ModelNode(name, name.isBlank() ? otherwise : shown, parent, Optional.empty());
  }

  /** Returns this part with another label. */
  public ModelNode labeled(String newLabel) {
    return new ModelNode(name, newLabel, parent, Optional.of(whole()));
  }

  /** Returns the part that this one belongs to; empty for none. */
  public Optional<ModelNode> parent() {
    return parent;
  }

  /**
   * Returns the part of the file that this one is a piece of, or has another label than; itself
   * otherwise.
   */
  public ModelNode whole() {
    return whole.orElse(this);
  }

  /** Returns the name in the file; empty if there is none. */
  public String name() {
    return name;
  }

  /**
   * Returns what users call the part: its name without control characters, of at most 61
   * characters, or what stands for it. Empty if the file is not divided.
   */
  public String label() {
    return label;
  }

  /** Returns whether the file divides the model into parts. */
  public boolean isDivided() {
    return !label.isEmpty();
  }

  /** Returns whether the name or the label of this part, or of one that it belongs to, matches. */
  public boolean matches(Predicate<String> wanted) {
    for (Optional<ModelNode> node = Optional.of(this); node.isPresent(); node = node.get().parent) {
      if (wanted.test(node.get().name) || wanted.test(node.get().label)) {
        return true;
      }
    }
    return false;
  }
}
