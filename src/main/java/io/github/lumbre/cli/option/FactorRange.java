package io.github.lumbre.cli.option;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.scene.SettingType;

/**
 * How far the parts of a model move apart: one factor, or a range for an animation. Immutable.
 *
 * @param last the same as the first for one picture
 */
record FactorRange(double first, double last) {
  /** The flag with such a value. */
  static final String FLAG = ModelOption.EXPLODE.flag();

  private static final String DOTS = "..";

  /**
   * Returns the factor or range in a text, such as {@code 0.5} or {@code 0..1}.
   *
   * @throws IllegalArgumentException if it has none, or a factor is out of range
   */
  static FactorRange of(String text) {
    int dots = text.indexOf(DOTS);
    if (dots < 0) {
      double factor = factor(text);
      return new FactorRange(factor, factor);
    }
    FactorRange range =
        new FactorRange(
            factor(text.substring(0, dots)), factor(text.substring(dots + DOTS.length())));
    if (!range.isRange()) {
      throw new IllegalArgumentException("expected a range of two factors, found " + text);
    }
    return range;
  }

  private static double factor(String text) {
    SettingType<Double> type = ModelOption.EXPLODE.type();
    double factor = type.parse(text);
    if (!type.accepts(factor)) {
      throw new IllegalArgumentException(type.refusal(factor));
    }
    return factor;
  }

  /** Returns whether this is an animation. */
  boolean isRange() {
    return first != last;
  }
}
