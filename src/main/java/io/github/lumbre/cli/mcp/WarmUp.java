package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CancellationException;

/**
 * Renders small pictures until the first call, and then searches by vectors, so that Java has
 * compiled most of the code by then. Speed hack: docs/measurements/2026-11-start.md.
 */
final class WarmUp {
  private static final int PICTURES = 36;
  private static final int WIDTH = 160;
  private static final int HEIGHT = 120;

  /** Triangles around each cone: enough for the traversal by vectors. */
  private static final int SIDES = 64;

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
      StagedModel model =
          StagedModel.read(
              "model.obj",
              model(),
              ModelFolder.NONE,
              Stage.DEFAULT.seenFrom(View.DEFAULT),
              new SceneParser()
                  .overriding(s -> s.toBuilder().samples(ViewsTool.DEFAULT_SAMPLES).build()));
      for (int i = 0; i < PICTURES; i++) {
        View view = new View(360. * i / PICTURES, 20);
        CleanPicture.light(model.seenFrom(view, WIDTH, HEIGHT), untilCall);
      }
      model.scene().scene().changeKernel(() -> !untilCall.isCancelled());
    } catch (SceneFormatException e) {
      throw new IllegalStateException(e);
    } catch (IOException | InterruptedException | CancellationException e) {
      // A call has come. Nothing is read from a file.
    }
  }

  /** Returns the text of a model: two cones with a common base. */
  private static byte[] model() {
    StringBuilder text = new StringBuilder("v 0 0 -1\nv 0 0 1\n");
    for (int i = 0; i < SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      text.append("v " + Math.cos(angle) + " " + Math.sin(angle) + " 0\n");
    }
    for (int i = 0; i < SIDES; i++) {
      int next = 3 + (i + 1) % SIDES;
      text.append("f 1 " + next + " " + (3 + i) + "\nf 2 " + (3 + i) + " " + next + "\n");
    }
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }
}
