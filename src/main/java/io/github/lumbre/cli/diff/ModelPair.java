package io.github.lumbre.cli.diff;

import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.difference.ModelDifference;
import io.github.lumbre.model.difference.ModelDifference.Side;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Two models that are compared.
 *
 * @param ofOld the stage of the old model
 * @param ofNow the stage of the new model
 */
public record ModelPair(Side old, Side now, Stage ofOld, Stage ofNow) {
  /** Reads a model. */
  public interface Source<E extends Exception> {
    Side read(ModelOptions options) throws E, IOException;
  }

  /**
   * Reads two models. If one of them states its axis and unit, and the other one does not, the
   * options for these are meant for the other one.
   *
   * @param stage of both
   */
  public static <E extends Exception> ModelPair read(Source<E> old, Source<E> now, Stage stage)
      throws E, IOException {
    Stage ofOld = beside(now, old, stage);
    Stage ofNow = beside(old, now, stage);
    return new ModelPair(read(old, ofOld), read(now, ofNow), ofOld, ofNow);
  }

  private static <E extends Exception> Stage beside(
      Source<E> other, Source<E> model, Stage stage) throws E, IOException {
    Stage own = stage.reading(stage.options().oriented(Optional.empty(), OptionalDouble.empty()));
    boolean isCorrected = !own.equals(stage);
    return isCorrected && statesUnit(model, own) && !statesUnit(other, own) ? own : stage;
  }

  private static <E extends Exception> boolean statesUnit(Source<E> model, Stage own)
      throws E, IOException {
    return !read(model, own).model().unit().isEmpty();
  }

  private static <E extends Exception> Side read(Source<E> model, Stage stage)
      throws E, IOException {
    return model.read(stage.options().mayLackFiles(true));
  }

  /**
   * Returns what changed.
   *
   * @param tolerance largest distance of vertices that count as the same, in the unit of the new
   *     file; empty for one of the models' size
   */
  public ChangeReport report(Optional<Double> tolerance) {
    double near =
        tolerance.isPresent()
            ? ModelDifference.space(now.model()).inWorld(tolerance.get())
            : ModelDifference.tolerance(old.model(), now.model());
    return new ChangeReport(ModelDifference.between(old, now, near), near);
  }
}
