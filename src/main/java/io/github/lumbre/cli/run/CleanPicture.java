package io.github.lumbre.cli.run;

import io.github.lumbre.image.Image;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.internal.PictureDrawing;
import java.util.Optional;
import java.util.function.Consumer;

/** Renders and denoises whole pictures that are not files. Stateless. */
public final class CleanPicture {
  private CleanPicture() {}

  /**
   * Returns the picture of a scene for the screen, with lines and labels.
   *
   * @param title the name of the view, if labels show it
   * @param notes receives a text for labels that have no room
   * @throws InterruptedException if the progress is cancelled or the thread interrupted
   */
  public static DisplayLight of(
      SceneFile file, String title, Consumer<String> notes, Progress progress)
      throws InterruptedException {
    PictureDrawing drawing = PictureDrawing.of(file.parsed(), notes);
    if (PictureDrawing.isAlone(file.parsed())) {
      return drawing.aloneOnDisplay(
          file.scene(), Optional.of(title), file.settings().development());
    }
    Image light = light(file, progress);
    return drawing
        .onDisplay(file.scene(), Optional.of(title), light, file.settings().development())
        .withBackground();
  }

  /**
   * Returns the picture of a scene in linear light, without lines and labels.
   *
   * @throws InterruptedException if the progress is cancelled or the thread interrupted
   */
  public static Image light(SceneFile file, Progress progress) throws InterruptedException {
    return BuiltInDenoiser.render(file.settings(), file.scene(), progress);
  }
}
