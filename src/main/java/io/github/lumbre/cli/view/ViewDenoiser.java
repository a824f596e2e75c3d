package io.github.lumbre.cli.view;

import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.stage.Stage;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Denoises the picture of a render while a page shows it denoised. The render waits meanwhile, and
 * the film stays as it is. Mutable, for one thread.
 */
final class ViewDenoiser {
  private static final long LOOK_MILLIS = 20;

  private final ViewSession session;
  private final ViewSession.Job job;
  private final RenderClock clock;
  private final DenoisingPace pace;
  private long denoised;

  /**
   * @param clock of the render, which stops while a picture is denoised
   * @param pace of this render, and of the next ones
   */
  ViewDenoiser(ViewSession session, ViewSession.Job job, RenderClock clock, DenoisingPace pace) {
    this.session = session;
    this.job = job;
    this.clock = clock;
    this.pace = pace;
    pace.restart();
  }

  /** Denoises the film of a running render if that is due. */
  void passed(Film film) {
    if (pace.isDue(clock.seconds()) && film.fewestSamples() > 1) {
      clock.stop();
      show(film);
      clock.start();
    }
  }

  /** Denoises a film in which every pixel has a sample, unless that is done already. */
  void show(Film film) {
    boolean isNew = film.totalSamples() != denoised && film.fewestSamples() > 0;
    if (!isNew || !session.viewers().wantsDenoised()) {
      return;
    }
    denoised = film.totalSamples();
    long start = System.nanoTime();
    try {
      unlessStale(film)
          .ifPresent(
              clean ->
                  session.showDenoised(
                      job,
                      Stage.withDrawing(job.file(), clean.image()),
                      film.meanSamples(),
                      Denoising.noting(clean, ImageWriter.Options.DEFAULT).metadata()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    pace.spend(clock.seconds(), 1e-9 * (System.nanoTime() - start));
  }

  /** Returns the denoised picture; empty if the camera was moved meanwhile, or memory is short. */
  private Optional<Denoised> unlessStale(Film film) throws InterruptedException {
    Denoising denoising = new Denoising(Optional.empty(), 0);
    FutureTask<Denoised> task = new FutureTask<>(() -> denoising.denoise(NoisyPicture.of(film)));
    Thread thread = new Thread(task, "lumbre-denoise");
    thread.setDaemon(true);
    thread.start();
    try {
      while (!session.isStale(job)) {
        try {
          return Optional.of(task.get(LOOK_MILLIS, TimeUnit.MILLISECONDS));
        } catch (TimeoutException e) {
          // Look whether the camera was moved.
          continue;
        }
      }
      return Optional.empty();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof OutOfMemoryError) {
        String advice = MemoryCheck.advice(Runtime.getRuntime().maxMemory() * 3 / 2);
        session.fail(List.of("not enough memory to denoise; " + advice));
        return Optional.empty();
      }
      throw new IllegalStateException(e.getCause());
    } finally {
      task.cancel(true);
    }
  }
}
