package io.github.lumbre.difference;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What happened to a part.
 *
 * @param kind what happened
 * @param old name of the part in the old model; empty if it was added
 * @param now name of the part in the new model; empty if it was removed
 * @param distance by which its centroid moved, in world units; 0 if it did not
 * @param degrees by which it was rotated
 * @param details in words, such as what changed; empty if the kind says everything
 */
public record PartChange(
    Kind kind,
    Optional<String> old,
    Optional<String> now,
    double distance,
    double degrees,
    List<String> details) {
  /** What happened to a part. */
  public enum Kind {
    /** It is in the new model only. */
    ADDED,
    /** It is in the old model only. */
    REMOVED,
    /** It has the same shape at another place. */
    MOVED,
    /** It has another shape, or another material. */
    CHANGED,
    /** It has another name, and nothing else. */
    RENAMED
  }

  public PartChange {
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(old, "old");
    Objects.requireNonNull(now, "now");
    details = List.copyOf(details);
  }

  /** Returns the name of the part, in the new model if it is there. */
  public String name() {
    return now.or(() -> old).orElseThrow();
  }
}
