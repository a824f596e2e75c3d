package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.image.internal.VectorPicture.Page;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.internal.PictureDrawing;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;

/**
 * Draws a picture of lines alone, which takes no samples: the same one whatever the flags of
 * sampling are.
 *
 * @param job whose picture it is
 */
public record DrawingJob(RenderJob job) {
  private static final String ACTIVITY = "drawing lines and labels";

  /** Draws and writes the picture. */
  public ExitCode run() throws TaskException, InterruptedException {
    long start = System.nanoTime();
    String size;
    try (RenderMonitor monitor = job.monitor()) {
      size = job.picture().isVector() ? vectors(monitor) : pixels(monitor);
    }
    double seconds = 1e-9 * (System.nanoTime() - start);
    PictureOutput picture = job.picture();
    boolean isStandard = picture.target().equals(PictureOutput.STANDARD);
    String name = isStandard ? "standard output" : picture.target().toString();
    job.said().line(String.format(Locale.ROOT, "%s: %s, lines, %.2f s", name, size, seconds));
    job.report().putScene(job.file());
    job.report().put("samples_per_pixel", 0);
    job.report().put("output", picture.target().toString());
    job.report().put("complete", true);
    job.report().put("seconds", seconds);
    job.report().put("samples", 0);
    return ExitCode.OK;
  }

  /**
   * Draws a model's lines and labels as vectors.
   *
   * @param notes receives a text for labels that have no room
   * @throws CancellationException if the command is stopped before they are drawn
   */
  public static VectorPicture vectors(
      ParsedScene file, RenderMonitor monitor, Consumer<String> notes)
      throws InterruptedException {
    return monitor
        .finishing(ACTIVITY, () -> PictureDrawing.vectors(file, Optional.empty(), notes))
        .orElseThrow(DrawingJob::stopped);
  }

  private String vectors(RenderMonitor monitor) throws TaskException, InterruptedException {
    VectorPicture drawing = vectors(file(), monitor, this::note);
    job.picture().write(drawing);
    Page page = drawing.page();
    String unit = page.unit().isEmpty() ? " pixels" : " " + page.unit();
    return PrintableText.number(page.width()) + "x" + PrintableText.number(page.height()) + unit;
  }

  private String pixels(RenderMonitor monitor) throws TaskException, InterruptedException {
    DisplayLight drawn =
        monitor.finishing(ACTIVITY, this::drawn).orElseThrow(DrawingJob::stopped);
    job.options().receiver().accept(drawn);
    Image image = drawn.image();
    job.picture()
        .write(
            image,
            drawn.options().withMetadata(PictureMetadata.ofDrawing(job.scene(), job.file())));
    return image.width() + "x" + image.height() + " pixels";
  }

  private DisplayLight drawn() {
    PictureDrawing drawing = PictureDrawing.of(file(), this::note);
    ImageWriter.Options options =
        new ImageWriter.Options(
            Exposure.NONE,
            file().settings().toneCurve(),
            job.options().bits(),
            job.options().jpegQuality(),
            Map.of(),
            file().settings().background(),
            Optional.of(file().settings().window().dither())
                .filter(dither -> job.options().dithered()));
    return job.picture().isForScreen()
        ? drawing.aloneOnDisplay(file().scene(), Optional.empty(), options)
        : new DisplayLight(drawing.aloneOnLight(file().scene(), Optional.empty()), options);
  }

  private ParsedScene file() {
    return job.file().parsed();
  }

  private void note(String text) {
    job.said().note(job.picture().target() + ": " + text);
  }

  private static CancellationException stopped() {
    return new CancellationException("stopped before the lines were drawn");
  }
}
