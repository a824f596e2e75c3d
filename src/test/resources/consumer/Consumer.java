package consumer;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;

/** Renders the scene that the first argument names to the picture that the second names. */
public final class Consumer {
  private Consumer() {}

  /** Prints nothing. */
  public static void main(String[] args) throws Exception {
    SceneFile file = new SceneParser().parse(Path.of(args[0]));
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    ImageWriter.write(image, Path.of(args[1]), file.settings().development());
  }
}
