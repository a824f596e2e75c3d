package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.function.BooleanSupplier;

/** Forwards all events to a listener, and also cancels if a condition holds. */
record CancellingProgress(Progress listener, BooleanSupplier condition) implements Progress {
  @Override
  public void started(long totalSamples) {
    listener.started(totalSamples);
  }

  @Override
  public void advanced(long samples) {
    listener.advanced(samples);
  }

  @Override
  public void stalled(Crop bucket, double seconds) {
    listener.stalled(bucket, seconds);
  }

  @Override
  public void finished(Crop bucket) {
    listener.finished(bucket);
  }

  @Override
  public boolean isCancelled() {
    return condition.getAsBoolean() || listener.isCancelled();
  }
}
