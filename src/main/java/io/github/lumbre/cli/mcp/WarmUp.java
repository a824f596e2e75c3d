package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.parser.ModelViews;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.parser.Stage;
import io.github.lumbre.parser.Stage.View;
import io.github.lumbre.render.Progress;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CancellationException;

/**
 * Renders small pictures until the first call, so that Java has compiled most of the code by then.
 * Speed hack: docs/measurements/2026-11-start.md.
 */
final class WarmUp {
  private static final int PICTURES = 24;
  private static final int WIDTH = 160;
  private static final int HEIGHT = 120;
  private static final byte[] MODEL =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"
          .getBytes(StandardCharsets.US_ASCII);

  private final Thread thread = new Thread(this::render, "lumbre-mcp-warm-up");

  private WarmUp() {}

  /** Starts to render. */
  static WarmUp start() {
    WarmUp warmUp = new WarmUp();
    warmUp.thread.setDaemon(true);
    warmUp.thread.setPriority(Thread.MIN_PRIORITY);
    warmUp.thread.start();
    return warmUp;
  }

  /** Ends the rendering. */
  void end() {
    thread.interrupt();
  }

  private void render() {
    Progress untilCall =
        new Progress() {
          @Override
          public boolean isCancelled() {
            return thread.isInterrupted();
          }
        };
    try {
      ModelViews model =
          new SceneParser()
              .overriding(s -> s.toBuilder().samples(Denoising.VIEW_SAMPLES).build())
              .parse("model.obj", MODEL, ModelFolder.NONE, Stage.DEFAULT, List.of(View.DEFAULT));
      for (int i = 0; i < PICTURES; i++) {
        View view = new View(360. * i / PICTURES, 20);
        CleanPicture.light(model.seenFrom(view, WIDTH, HEIGHT), untilCall);
      }
    } catch (SceneFormatException e) {
      throw new IllegalStateException(e);
    } catch (IOException | InterruptedException | CancellationException e) {
      // A call has come. Nothing is read from a file.
    }
  }
}
