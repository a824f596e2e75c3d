package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.mcp.Studio.Finished;
import io.github.lumbre.cli.mcp.Studio.Frame;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.ContactSheet;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Renders a model from all sides on one sheet. */
record ViewsTool(Studio studio) implements Tool {
  private static final int MOST_PIXELS = 640;
  private static final int MOST_SAMPLES = 16;
  private static final int COLUMNS = 4;

  /** The samples per pixel unless a call has others. */
  static final int DEFAULT_SAMPLES = 1;

  private static final Input<Integer> WIDTH =
      Input.integer("width", 16, MOST_PIXELS, 320, "Width of each picture in pixels.");

  private static final Input<Integer> HEIGHT =
      Input.integer("height", 16, MOST_PIXELS, 240, "Height of each picture in pixels.");

  private static final int AT_ONCE = 2;

  private static final Input<Integer> SAMPLES =
      Input.integer(
          "samples",
          1,
          MOST_SAMPLES,
          DEFAULT_SAMPLES,
          "Samples per pixel: more have smoother edges, and take longer.");

  @Override
  public String name() {
    return "views";
  }

  @Override
  public String title() {
    return "Show a model from all sides";
  }

  @Override
  public String description() {
    return "Renders a 3D model from the front, back, left, right, top, bottom and isometrically, on"
        + " one PNG picture: four views in the upper row, three in the lower one, in this order.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs = new ArrayList<>(List.of(ModelInputs.MODEL, WIDTH, HEIGHT, SAMPLES));
    inputs.addAll(ModelInputs.withoutPlace());
    return inputs;
  }

  @Override
  public List<Output> outputs() {
    return SummaryOutputs.ofPictures();
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    Stage stage = ModelInputs.stage(arguments);
    Studio.Staged model = studio.model(arguments.get(ModelInputs.MODEL), stage);
    Frame frame =
        new Frame(arguments.get(WIDTH), arguments.get(HEIGHT), arguments.get(SAMPLES));
    List<Shot> shots = new ArrayList<>();
    for (Map.Entry<String, View> view : View.standard().entrySet()) {
      shots.add(model.shot(stage.seenFrom(view.getValue()), view.getKey(), frame));
    }
    progress.expect((long) frame.width() * frame.height() * frame.samples() * shots.size());
    JsonSummary summary = model.summary(name());
    List<Finished> views =
        pictures(shots, progress, () -> shots.forEach(shot -> shot.describe(summary)));
    summary.put("notes", views.stream().flatMap(view -> view.notes().stream()).toList());
    List<Image> images = views.stream().map(view -> view.picture().image()).toList();
    Image sheet = ContactSheet.of(images, COLUMNS, Math.max(1, frame.width() / 64));
    return new Outcome(
        List.of(ImageFormat.PNG.bytes(sheet, views.get(0).picture().options())),
        model.rounding().values(summary.values()));
  }

  /**
   * Renders two pictures at a time: parts of the work on one of them have a single thread.
   *
   * @param beside what is done meanwhile
   */
  private static List<Finished> pictures(
      List<Shot> shots, CallProgress progress, Runnable beside) throws InterruptedException {
    ExecutorService pool = Executors.newFixedThreadPool(AT_ONCE);
    try {
      List<Future<Finished>> running = new ArrayList<>();
      shots.forEach(shot -> running.add(pool.submit(() -> picture(shot, progress))));
      beside.run();
      List<Finished> pictures = new ArrayList<>();
      for (Future<Finished> picture : running) {
        pictures.add(picture.get());
      }
      return pictures;
    } catch (ExecutionException e) {
      throw failure(e.getCause());
    } finally {
      pool.shutdownNow();
    }
  }

  private static Finished picture(Shot shot, CallProgress progress) throws InterruptedException {
    List<String> notes = new ArrayList<>();
    String name = shot.title();
    return new Finished(
        CleanPicture.of(shot.file(), name, note -> notes.add(name + ": " + note), progress), notes);
  }

  /** Returns or throws what ended a picture, such as the end of the call. */
  private static RuntimeException failure(Throwable cause) throws InterruptedException {
    if (cause instanceof InterruptedException interruption) {
      throw interruption;
    }
    if (cause instanceof Error error) {
      throw error;
    }
    return (RuntimeException) cause;
  }
}
