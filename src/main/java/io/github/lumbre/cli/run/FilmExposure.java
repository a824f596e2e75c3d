package io.github.lumbre.cli.run;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProblemText;
import io.github.lumbre.cli.output.Visible;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.nio.file.Path;

/** The exposure of pictures that are made from films. */
public final class FilmExposure {
  private FilmExposure() {}

  /**
   * Returns the exposure that a render gives the picture of a film. An automatic one of a model
   * depends on the pixels that the model covers, so that the model is read for it. If that fails,
   * prints a warning and returns the automatic exposure of the whole picture.
   *
   * @param path of the film
   */
  public static Exposure of(Exposure wanted, Path path, FilmFile film, Messages messages)
      throws TaskException {
    FilmNotes notes = new FilmNotes(path, film.header());
    Path model = notes.scene();
    if (wanted.stops().isPresent() || notes.sceneText(model).isEmpty()) {
      return wanted;
    }
    String problem;
    try {
      SceneFile file = notes.read(notes.parser(settings -> {}), model);
      if (file.hash().equals(film.header().identity().get(FilmHeader.SCENE_HASH))) {
        return Visible.exposure(wanted, file, film.film().develop());
      }
      problem = model.getFileName() + ": has changed since it was rendered";
    } catch (SceneFormatException e) {
      problem = ProblemText.of(e).get(0);
    } catch (IOException e) {
      problem = model.getFileName() + ": cannot be read: " + FileFailure.reason(e);
    }
    messages.line(
        ("warning: %s; without the film's model, %s, the automatic exposure is measured over the"
                + " whole picture")
            .formatted(problem, model));
    return wanted;
  }
}
