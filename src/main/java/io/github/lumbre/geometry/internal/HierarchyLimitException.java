package io.github.lumbre.geometry.internal;

/** A hierarchy would have more items than its numbers can hold. The message says which limit. */
public final class HierarchyLimitException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  /** Creates an exception with its message. */
  public HierarchyLimitException(String message) {
    super(message);
  }
}
