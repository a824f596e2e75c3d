package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests what ends the passes of a render, with a renderer that only counts. */
@Timeout(60)
class PassLoopTest {
  private static final int GOAL = 8;
  private static final int PIXELS = 6;

  private final Film film = new Film(new Crop(0, 0, PIXELS, 1), false, 0);

  /** The samples of the most complete pixel after each pass. */
  private final List<Integer> passes = new ArrayList<>();

  private OptionalDouble seconds = OptionalDouble.empty();

  /** Adds black samples, pixel by pixel, while it is not cancelled. */
  private final class Counter implements PassRenderer {
    @Override
    public Schedule schedule() {
      return Schedule.even(GOAL, Passes::next);
    }

    @Override
    public OptionalDouble seconds(Film film, SampleTarget target) {
      return seconds;
    }

    @Override
    public PassResult addSamples(Film film, SampleTarget target, Progress progress) {
      long before = film.totalSamples();
      for (int x = 0; x < PIXELS; x++) {
        while (film.samples(x) < target.samples(x, 0) && !progress.isCancelled()) {
          film.add(x, Rgb.BLACK, true);
        }
      }
      passes.add(film.mostSamples());
      RenderStatistics added =
          new RenderStatistics(film.totalSamples() - before, 0, 0, 0, List.of(), 0, 0, 0, 0);
      return new PassResult(film.fewestSamples() == target.samples(0, 0), added);
    }
  }

  private PassResult run(StopRule rule, PassListener listener, Progress progress)
      throws InterruptedException {
    return new PassLoop(new Counter(), film).run(rule, listener, progress);
  }

  private static StopRule after(int samples) {
    return new StopRule() {
      private boolean isMet;

      @Override
      public void passed(Film film) {
        isMet = film.fewestSamples() >= samples;
      }

      @Override
      public boolean isMet() {
        return isMet;
      }
    };
  }

  private static StopRule timed(double left) {
    return new StopRule() {
      @Override
      public OptionalDouble secondsLeft() {
        return OptionalDouble.of(left);
      }
    };
  }

  @Test
  void allPassesAreRenderedAndCounted() throws InterruptedException {
    PassResult result = new PassLoop(new Counter(), film).run(Progress.NONE);
    assertThat(passes).containsExactly(1, 2, 4, 8);
    assertThat(result.complete()).isTrue();
    assertThat(result.statistics().samples()).isEqualTo(GOAL * PIXELS);
  }

  @Test
  void ruleEndsTheRenderAfterACompletePass() throws InterruptedException {
    assertThat(run(after(3), PassListener.NONE, Progress.NONE).complete()).isTrue();
    assertThat(passes).containsExactly(1, 2, 4);
  }

  @Test
  void firstPassIsCompletedThoughTheTimeIsOver() throws InterruptedException {
    assertThat(run(timed(0), PassListener.NONE, Progress.NONE).complete()).isTrue();
    assertThat(passes).containsExactly(1);
    assertThat(film.fewestSamples()).isEqualTo(1);
  }

  @Test
  void timeCutsLaterPassesShort() throws InterruptedException {
    AtomicInteger looks = new AtomicInteger();
    StopRule rule =
        new StopRule() {
          @Override
          public OptionalDouble secondsLeft() {
            return OptionalDouble.of(4 - looks.getAndIncrement());
          }
        };
    assertThat(run(rule, PassListener.NONE, Progress.NONE).complete()).isTrue();
    assertThat(passes).containsExactly(1, 2);
    assertThat(film.fewestSamples()).isEqualTo(1);
  }

  @Test
  void passThatTakesLongerThanTheTimeLeftIsNotBegun() throws InterruptedException {
    seconds = OptionalDouble.of(3);
    assertThat(run(timed(2), PassListener.NONE, Progress.NONE).complete()).isTrue();
    assertThat(passes).containsExactly(1);
  }

  @Test
  void passWhoseTimeIsKnownIsNotPaused() throws InterruptedException {
    seconds = OptionalDouble.of(3);
    run(timed(4), impatient(new ArrayList<>()), Progress.NONE);
    assertThat(passes).containsExactly(1, 2, 4, 8);
  }

  /**
   * Returns a listener that pauses each pass twice: before its third pixel and before its fifth.
   */
  private static PassListener impatient(List<PassResult> received) {
    AtomicInteger calls = new AtomicInteger();
    return new PassListener() {
      @Override
      public boolean isDue() {
        return calls.incrementAndGet() % 3 == 0;
      }

      @Override
      public void passed(Film film, PassResult soFar) {
        received.add(soFar);
      }
    };
  }

  @Test
  void pausedPassesAreContinued() throws InterruptedException {
    List<PassResult> received = new ArrayList<>();
    PassResult result = run(StopRule.NONE, impatient(received), Progress.NONE);
    assertThat(result.complete()).isTrue();
    assertThat(film.fewestSamples()).isEqualTo(GOAL);
    assertThat(received).filteredOn(PassResult::complete).hasSize(4);
    assertThat(received).filteredOn(pass -> !pass.complete()).isNotEmpty();
    assertThat(received.get(received.size() - 1)).isEqualTo(result);
  }

  @Test
  void cancelledRenderIsContinuedByTheNextRun() throws InterruptedException {
    AtomicInteger left = new AtomicInteger(10);
    Progress cancelled = Progress.NONE.cancelledAlsoIf(() -> left.getAndDecrement() <= 0);
    PassLoop loop = new PassLoop(new Counter(), film);
    assertThat(loop.run(cancelled).complete()).isFalse();
    assertThat(film.mostSamples()).isEqualTo(2);
    assertThat(loop.run(Progress.NONE).complete()).isTrue();
    assertThat(film.fewestSamples()).isEqualTo(GOAL);
  }

  @Test
  void completeFilmStaysAsItIs() throws InterruptedException {
    run(StopRule.NONE, PassListener.NONE, Progress.NONE);
    passes.clear();
    assertThat(run(after(1), PassListener.NONE, Progress.NONE).complete()).isTrue();
    assertThat(passes).isEmpty();
  }
}
