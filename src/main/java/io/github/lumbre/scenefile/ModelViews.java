package io.github.lumbre.scenefile;

import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.Stage.View;
import java.util.List;

/**
 * A model seen from several directions. Its scenes share everything but the camera. Confined to one
 * thread at a time.
 */
public final class ModelViews {
  private final StagedModel model;
  private final SceneFile first;
  private final List<Scene> scenes;

  /**
   * @param views at least one
   */
  ModelViews(StagedModel model, List<View> views, SceneParser parser) throws SceneFormatException {
    this.model = model;
    first = model.scene(parser);
    double frameAspect = parser.settings().frameAspect();
    scenes = List.copyOf(model.seenFrom(views, first, frameAspect));
  }

  /** Returns the scene file of the first view, with the settings of all. */
  public SceneFile first() {
    return first;
  }

  /** Returns the scenes of all views, in order. */
  public List<Scene> scenes() {
    return scenes;
  }

  /**
   * Returns the model from another direction, framed for a picture of another size.
   *
   * @param width of the picture in pixels, at least 1
   * @param height of the picture in pixels, at least 1
   */
  public SceneFile seenFrom(View view, int width, int height) throws SceneFormatException {
    return seenFrom(view, width, height, model.framing());
  }

  /**
   * Returns the model from another direction, by a camera that frames this model and another one.
   *
   * @param other whose scene has the same camera
   * @param width of the picture in pixels, at least 1
   * @param height of the picture in pixels, at least 1
   */
  public SceneFile seenBeside(ModelViews other, View view, int width, int height)
      throws SceneFormatException {
    return seenFrom(view, width, height, model.framing().with(other.model.framing()));
  }

  private SceneFile seenFrom(View view, int width, int height, Framing framing)
      throws SceneFormatException {
    SceneFile sized = first.with(first.settings().toBuilder().size(width, height).build());
    double aspect = (double) width / height;
    return sized.with(model.seenFrom(List.of(view), sized, aspect, framing).get(0));
  }

  /** Returns about how many bytes of memory the model and its scenes take. */
  public long memory() {
    return model.memory();
  }
}
