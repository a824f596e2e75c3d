package io.github.lumbre.cli.view;

import io.github.lumbre.scene.Layer;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/** Who looks at a session, at which layers, and what that costs. Thread-safe. */
final class Viewers {
  /** A page that has not asked for anything for this time is closed or hidden. */
  static final long PATIENCE_NANOS = 4_000_000_000L;

  /** A layer that was not requested for this time is not developed any more. */
  private static final long LAYER_NANOS = 15_000_000_000L;

  private final LongSupplier clock;
  private final Map<Layer, Long> layers = new EnumMap<>(Layer.class);
  private final AtomicLong costNanos = new AtomicLong();
  private volatile long lastSeen;
  private volatile long lastDenoised;
  private volatile boolean isUrgent;

  /**
   * @param clock in nanoseconds
   */
  Viewers(LongSupplier clock) {
    this.clock = clock;
    lastSeen = clock.getAsLong() - 2 * PATIENCE_NANOS;
    lastDenoised = lastSeen;
  }

  /** Notes that a page has asked for something. */
  void seen() {
    if (!areWatching()) {
      isUrgent = true;
    }
    lastSeen = clock.getAsLong();
  }

  /** Returns whether a page is open and visible. */
  boolean areWatching() {
    return clock.getAsLong() - lastSeen < PATIENCE_NANOS;
  }

  /** Notes that a page shows the denoised picture. */
  void wantDenoised() {
    if (!wantsDenoised()) {
      isUrgent = true;
    }
    lastDenoised = clock.getAsLong();
  }

  /** Returns whether a page is visible and shows the denoised picture. */
  boolean wantsDenoised() {
    return clock.getAsLong() - lastDenoised < PATIENCE_NANOS;
  }

  /** Notes that layers are needed. */
  synchronized void want(Set<Layer> wanted) {
    long now = clock.getAsLong();
    wanted.forEach(layer -> layers.put(layer, now));
  }

  /** Requests a preview now. */
  void hurry() {
    isUrgent = true;
  }

  boolean isUrgent() {
    return isUrgent;
  }

  /** Notes that a preview is being made. */
  void served() {
    isUrgent = false;
  }

  /** Returns the layers that were requested lately. */
  synchronized Set<Layer> layers() {
    long now = clock.getAsLong();
    layers.values().removeIf(time -> now - time > LAYER_NANOS);
    Set<Layer> wanted = EnumSet.noneOf(Layer.class);
    wanted.addAll(layers.keySet());
    return wanted;
  }

  /** Adds the cost of sending or drawing a preview. */
  void spend(long nanos) {
    costNanos.addAndGet(nanos);
  }

  /** Returns the rendering time, in seconds, that was lost since the last call. */
  double takeCost() {
    // The work of one processor, while the render uses all.
    return costNanos.getAndSet(0) * 1e-9 / Runtime.getRuntime().availableProcessors();
  }
}
