package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.LaterStep;
import io.github.lumbre.cli.output.LightReport;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.internal.PictureDrawing;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A picture after its samples: denoised, with lines and labels. If the render was stopped before
 * the film had all its samples, or one of these steps is stopped, the picture lacks it.
 *
 * @param light the picture and how to write it
 * @param missing the steps that the picture lacks
 * @param loss the energy that the picture lacks
 */
record LaterSteps(
    DisplayLight light, DenoisedPicture denoised, Set<LaterStep> missing, LightReport loss) {
  /**
   * Does the steps.
   *
   * @param result of the film; complete if the film has all its samples
   * @throws InterruptedException if the calling thread is interrupted
   */
  static LaterSteps of(RenderJob job, Film film, RenderResult result, Exposure exposure)
      throws InterruptedException {
    return new Work(job, film, result).done(exposure);
  }

  /** Returns how to write the picture, with its metadata and those of the denoiser. */
  ImageWriter.Options options(Map<String, String> metadata) {
    return denoised.noting(light.options().withMetadata(metadata));
  }

  /** What the steps are done on. */
  private record Work(RenderJob job, Film film, RenderResult result) {
    LaterSteps done(Exposure exposure) throws InterruptedException {
      ImageWriter.Options options =
          new ImageWriter.Options(
              exposure,
              job.file().settings().toneCurve(),
              job.options().bits(),
              job.options().jpegQuality(),
              Map.of(),
              job.file().settings().background(),
              Optional.of(job.file().settings().window().dither())
                  .filter(dither -> job.options().dithered()));
      Set<LaterStep> missing = EnumSet.noneOf(LaterStep.class);
      DenoisedPicture denoised = denoised();
      if (denoised.isMissing()) {
        missing.add(LaterStep.DENOISING);
      }
      Image image = denoised.image(result.image());
      Optional<DisplayLight> drawn = drawn(image, options);
      if (drawn.isEmpty()) {
        missing.add(LaterStep.DRAWING);
        job.said().line("no lines and labels are drawn, because the render was stopped");
      }
      DisplayLight light = drawn.orElse(new DisplayLight(image, options));
      return new LaterSteps(light, denoised, missing, loss());
    }

    private DenoisedPicture denoised() {
      Optional<FrameWindow> window = job.options().window();
      if (window.isPresent()) {
        int threads = job.options().denoising().orElseThrow().usedThreads();
        return new DenoisedPicture(
            Optional.of(window.get().mixed(threads, job.monitor())), Optional.empty(), true);
      }
      return job.options()
          .denoising()
          .map(chosen -> chosen.withThreads(job.file().settings().threads()))
          .map(
              chosen ->
                  DenoisedPicture.of(
                      film,
                      chosen,
                      job.picture().target(),
                      result.complete(),
                      job.said(),
                      job.monitor()))
          .orElse(DenoisedPicture.NOISY);
    }

    /** Returns the picture with its lines and labels; empty if it lacks them. */
    private Optional<DisplayLight> drawn(Image image, ImageWriter.Options options) {
      if (!PictureDrawing.isNeeded(job.file().parsed())) {
        return Optional.of(new DisplayLight(image, options));
      }
      return result.complete()
          ? job.monitor().finishing("drawing lines and labels", () -> onto(image, options))
          : Optional.empty();
    }

    private DisplayLight onto(Image image, ImageWriter.Options options) {
      PictureDrawing drawing =
          PictureDrawing.of(
              job.file().parsed(),
              note -> job.said().note(job.picture().target() + ": " + note));
      return job.picture().isForScreen()
          ? drawing.onDisplay(job.file().scene(), Optional.empty(), image, options)
          : new DisplayLight(
              drawing.onLight(
                  job.file().scene(),
                  Optional.empty(),
                  Backdrop.asLight(image, options.background())),
              options);
    }

    /** Estimates the lost energy; a stopped render skips the slow estimates. */
    private LightReport loss() throws InterruptedException {
      Optional<LightReport> report =
          result.complete()
              ? job.monitor()
                  .finishing("estimating the energy lost", () -> loss(job.options().quiet()))
              : Optional.empty();
      return report.isPresent() ? report.get() : loss(true);
    }

    private LightReport loss(boolean isBrief) throws InterruptedException {
      return LightReport.of(job.file(), film, result.statistics(), isBrief);
    }
  }
}
