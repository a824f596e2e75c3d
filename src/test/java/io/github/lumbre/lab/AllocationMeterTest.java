package io.github.lumbre.lab;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the measurement of allocation per thread. */
class AllocationMeterTest {
  private static final int LARGE = 1 << 24;
  private static final Crop BUCKET = new Crop(0, 0, 1, 1);

  private final List<Object> kept = new ArrayList<>();

  @Test
  void threadsSumAndWhatOneAllocatesCountsOnce() throws InterruptedException {
    AllocationMeter meter = new AllocationMeter(Progress.NONE);
    for (int i = 0; i < 3; i++) {
      Thread thread =
          new Thread(
              () -> {
                kept.add(new byte[LARGE]);
                meter.finished(BUCKET);
                meter.finished(BUCKET);
              });
      thread.start();
      thread.join();
    }
    assertThat(meter.bytes()).isBetween(3L * LARGE, 3L * LARGE + LARGE / 10);
  }

  @Test
  void everythingIsPassedOn() {
    List<String> heard = new ArrayList<>();
    Progress listener =
        new Progress() {
          @Override
          public void started(long totalSamples) {
            heard.add("started " + totalSamples);
          }

          @Override
          public void advanced(long samples) {
            heard.add("advanced " + samples);
          }

          @Override
          public void finished(Crop bucket) {
            heard.add("finished " + bucket.width());
          }

          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    AllocationMeter meter = new AllocationMeter(listener);
    meter.started(5);
    meter.advanced(3);
    meter.finished(BUCKET);
    assertThat(heard).containsExactly("started 5", "advanced 3", "finished 1");
    assertThat(meter.isCancelled()).isTrue();
  }
}
