package io.github.lumbre.scenefile.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.scenefile.SceneFormatException;

/** A model that is rendered by itself, and was read. Mutable; confined to one thread. */
public interface LoneModel {
  /** Returns the model as it was read, neither cut nor exploded. */
  Model model();

  /** Returns what is left of the limits. */
  Limits left();

  /** Returns about how many bytes the model and its scene take. */
  long memory();

  /** Requires that a box around the model has a finite size. */
  void requireMeasurable(Bounds3 box) throws SceneFormatException;

  /** Returns the exception for the model, which cannot be used. */
  SceneFormatException failure(SceneFormatException.Kind kind, String place, String message);

  SceneFormatException failure(ModelFormatException e);

  /** Keeps the files in memory, for {@link #hashOf} and {@link #seenIn}. */
  void keepFiles();

  /**
   * Returns the scene around the model. Call it once.
   *
   * @param shown the model, or what is left of it
   * @param decoded the pictures of other poses of the model
   */
  ParsedScene scene(Model shown, Surroundings around, DecodedPictures decoded)
      throws SceneFormatException;

  /**
   * Returns the scene that differs from one that was built in its camera and title alone, if the
   * files were kept. The scenes share everything else.
   */
  ParsedScene seenIn(Model shown, Surroundings around, ParsedScene built);

  /** Returns the text of a scene: one line, which the header of a checkpoint file can hold. */
  byte[] text(Surroundings around);

  /**
   * Returns the hash of a scene around this model, once one has been built with the files kept.
   *
   * @param text of the scene
   */
  String hashOf(byte[] text);
}
