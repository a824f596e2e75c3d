package io.github.lumbre.model.difference;

import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What happened to a part of a model, or to something else in its file.
 *
 * @param kind what happened
 * @param of what it happened to
 * @param old name in the old model; empty if it was added
 * @param now name in the new model; empty if it was removed
 * @param shift of its centroid, in the axes and the unit of the new file; 0 if it did not move
 * @param degrees by which it was rotated
 * @param details in words, such as what changed; empty if the kind says everything
 * @param oldParts names of the parts in the old model that it stands for
 * @param nowParts names of the parts in the new model that it stands for
 */
public record PartChange(
    Kind kind,
    Subject of,
    Optional<String> old,
    Optional<String> now,
    Vec3 shift,
    double degrees,
    List<String> details,
    List<String> oldParts,
    List<String> nowParts) {
  /** What happened. */
  public enum Kind {
    /** It is in the new model only. */
    ADDED,
    /** It is in the old model only. */
    REMOVED,
    /** It has the same shape at another place. */
    MOVED,
    /** It has another shape or look. */
    CHANGED,
    /** It has another name, and nothing else. */
    RENAMED
  }

  /** What something happened to. */
  public enum Subject {
    PART,
    LIGHT,
    CAMERA,
    ANIMATION,
    VARIANT
  }

  public PartChange {
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(of, "of");
    Objects.requireNonNull(old, "old");
    Objects.requireNonNull(now, "now");
    Objects.requireNonNull(shift, "shift");
    details = List.copyOf(details);
    oldParts = List.copyOf(oldParts);
    nowParts = List.copyOf(nowParts);
  }

  /** Returns a change of one part. */
  static PartChange ofPart(
      Kind kind,
      Optional<String> old,
      Optional<String> now,
      Vec3 shift,
      double degrees,
      List<String> details) {
    return new PartChange(
        kind,
        Subject.PART,
        old,
        now,
        shift,
        degrees,
        details,
        old.stream().toList(),
        now.stream().toList());
  }

  /** Returns the name, in the new model if it is there. */
  public String name() {
    return now.or(() -> old).orElseThrow();
  }

  /** Returns the length of the shift. */
  public double distance() {
    return shift.length();
  }
}
