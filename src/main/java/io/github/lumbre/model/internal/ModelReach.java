package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;

/**
 * Checks that a model has a size with which rays, cameras and sections can compute. Volumes, and so
 * the determinants of transforms, neither overflow nor vanish within these bounds. Stateless.
 */
public final class ModelReach {
  /** The largest absolute coordinate. */
  public static final double LARGEST = 1e100;

  /** The smallest size of a whole model, except for one that is a single point. */
  public static final double SMALLEST = 1e-100;

  private ModelReach() {}

  /**
   * Checks where the parts of a model are.
   *
   * @throws ModelFormatException at a part whose transform is not invertible, or which extends too
   *     far, or if the whole model is too small
   */
  static void require(Model model) throws ModelFormatException {
    Bounds3 all = Bounds3.EMPTY;
    for (ModelPart part : model.parts()) {
      requireInvertible(part, part.toWorld());
      Bounds3 box = part.toWorld().bounds(part.geometry().bounds());
      double radius = part.geometry().isPoints() ? model.pointRadius() : 0;
      double reach = Math.max(box.min().maxAbs(), box.max().maxAbs()) + radius;
      if (part.geometry().vertexCount() > 0 && !(reach <= LARGEST)) {
        throw Kind.MALFORMED.at(
            part.location(),
            "expected a part within 1e100 of the origin, found one that extends beyond");
      }
      all = all.union(box);
    }
    double size = all.isEmpty() ? 0 : all.max().minus(all.min()).maxAbs();
    if (size > 0 && size < SMALLEST) {
      throw Kind.MALFORMED.at(
          "",
          "expected a model of at least 1e-100 in size, found " + PrintableText.number(size));
    }
  }

  /**
   * Checks the transform of a part.
   *
   * @throws ModelFormatException at the part, if the transform is not invertible
   */
  static void requireInvertible(ModelPart part, Transform toWorld) throws ModelFormatException {
    if (!toWorld.isInvertible()) {
      throw Kind.MALFORMED.at(
          part.location(),
          "expected an invertible transform, found one with the determinant "
              + PrintableText.number(toWorld.determinant()));
    }
  }
}
