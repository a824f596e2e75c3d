package io.github.lumbre.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.ModelSample;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.internal.PictureTexts;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests pictures that are stopped after their last sample, with a simulated clock. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LaterStepsTest {
  private static final Duration LIMIT = Duration.ofSeconds(1);

  @TempDir private Path directory;

  private final AtomicLong nanos = new AtomicLong();
  private final StringWriter told = new StringWriter();
  private final JsonSummary report = new JsonSummary("render", Path.of("a.glb"));

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  /** Lets time pass when an activity begins. */
  private record Events(String activity, Runnable event) implements ProgressDisplay {
    @Override
    public void busy(String begun) {
      if (begun.startsWith(activity)) {
        event.run();
      }
    }

    @Override
    public void started(long totalSamples) {}

    @Override
    public void expected(long furtherSamples) {}

    @Override
    public void advanced(long samples) {}

    @Override
    public void close() {}
  }

  private SceneFile scene() throws Exception {
    Stage stage =
        Stage.DEFAULT.with(Stage.LINE_WIDTH, 1.5).with(Stage.LABEL, List.of("axes"));
    SceneParser parser =
        new SceneParser()
            .overriding(
                settings ->
                    settings.toBuilder()
                        .samples(2)
                        .size(64, 48)
                        .set(Setting.LAYERS, Layer.FOR_DENOISING)
                        .build());
    return StagedModel.read(directory.resolve("sample.glb"), stage, parser).scene();
  }

  private interface Event {
    void happen(Interruption interruption);
  }

  /** Renders a picture with lines, labels and a denoiser, and returns its metadata. */
  private Map<String, String> render(String activity, Event event) throws Exception {
    SceneFile file = scene();
    Path target = directory.resolve("a.png");
    Files.deleteIfExists(target);
    Messages messages = new Messages(new PrintWriter(told, true));
    try (PictureOutput picture = PictureOutput.reserve(target, Fallback.TEMPORARY);
        FilmKeeper keeper = FilmKeeper.none(messages);
        Interruption interruption = Interruption.listen();
        RenderMonitor monitor =
            new RenderMonitor(
                interruption,
                new Events(activity, () -> event.happen(interruption)),
                Deadline.after(Optional.of(LIMIT), nanos::get),
                messages)) {
      RunBudget budget =
          new RunBudget(new Budget(2, OptionalDouble.empty(), .95), Deadline.NEVER);
      RenderJob.Options options =
          new RenderJob.Options(
              8,
              90,
              false,
              false,
              false,
              Optional.of(new Denoising(Optional.empty(), 1)),
              Set.of(),
              PictureExposure.ofEach(),
              drawn -> {},
              hint -> {},
              true,
              Optional.empty());
      Path model = directory.resolve("sample.glb");
      RenderJob job =
          new RenderJob(
              model,
              file,
              picture,
              keeper,
              monitor,
              messages,
              report,
              budget,
              options,
              Engine.LOCAL);
      assertThat(job.run(0)).isEqualTo(ExitCode.OK);
    }
    return PictureTexts.read(target);
  }

  private void pass(int seconds) {
    nanos.addAndGet(TimeUnit.SECONDS.toNanos(seconds));
  }

  @ParameterizedTest
  @CsvSource({
    "denoising, 'not denoised, without lines and labels', 'denoising drawing'",
    "drawing, without lines and labels, drawing"
  })
  void picturesThatLackAStepArePartial(String activity, String lack, String missing)
      throws Exception {
    Map<String, String> texts = render(activity, interruption -> pass(5));
    assertThat(texts).containsEntry("Partial", "2 of 2 samples per pixel, " + lack);
    assertThat(report.isPartial()).isTrue();
    assertThat(report.values())
        .containsEntry("missing", List.of(missing.split(" ")))
        .containsEntry("stopped_by", "timeout");
    assertThat(told.toString())
        .contains("a.png: partial picture of 64x48 pixels, 2 of 2 samples per pixel, " + lack);
  }

  @ParameterizedTest
  @CsvSource({"denoising", "drawing", "estimating", "writing"})
  void stepsThatEndSoonAfterTheDeadlineCompleteThePicture(String activity) throws Exception {
    Map<String, String> whole = render("none", interruption -> {});
    byte[] pixels = pixels();
    Map<String, String> texts = render(activity, interruption -> pass(3));
    assertThat(texts).doesNotContainKey("Partial").containsKey("Denoised");
    assertThat(texts.keySet()).containsExactlyElementsOf(whole.keySet());
    assertThat(report.values()).containsEntry("complete", true).doesNotContainKey("missing");
    assertThat(pixels()).isEqualTo(pixels);
  }

  private byte[] pixels() throws IOException {
    return ImageReader.decode(Files.readAllBytes(directory.resolve("a.png"))).toPng();
  }

  @Test
  void stepsEndThreeSecondsAfterASignal() {
    try (Interruption interruption = Interruption.listen()) {
      interruption.beginRender();
      CountDownLatch never = new CountDownLatch(1);
      long start = System.nanoTime();
      Thread signal = new Thread(interruption::request);
      Optional<Boolean> done =
          interruption.finishing(
              Deadline.NEVER,
              () -> {
                signal.start();
                return never.await(20, TimeUnit.SECONDS);
              });
      assertThat(done).isEmpty();
      assertThat(System.nanoTime() - start).isBetween(2_900_000_000L, 15_000_000_000L);
      assertThat(interruption.finishing(Deadline.NEVER, () -> never.await(20, TimeUnit.SECONDS)))
          .isEmpty();
      assertThat(Thread.currentThread().isInterrupted()).isFalse();
    }
  }

  @Test
  void stepsAfterASignalHaveTheirTime() {
    try (Interruption interruption = Interruption.listen()) {
      interruption.request();
      assertThat(interruption.finishing(Deadline.NEVER, () -> "done")).contains("done");
    }
  }
}
