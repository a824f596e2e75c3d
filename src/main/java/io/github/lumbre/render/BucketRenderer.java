package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.integrator.SampleLayers;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Renders buckets until the queue is empty or stopped. Confined to one thread. */
final class BucketRenderer implements Runnable {
  /** The number of samples between progress reports. */
  private static final int SAMPLES_PER_REPORT = 1024;

  /** The number of samples between checks for cancellation. */
  private static final int SAMPLES_PER_QUESTION = 16;

  private static final int MAX_REPORTED_REJECTS = 10;

  private final RenderSettings settings;

  /** Whether samples that hit nothing do not cover their pixel. */
  private final boolean countsCoverage;

  /** The light of samples without a ray. */
  private final Rgb blank;

  private final TracedPose[] poses;
  private final Film film;
  private final SampleTarget target;
  private final RenderQueue queue;

  private final SampleLimit limit;

  /** Samples whose largest component is at most this are added to the film unchanged. */
  private final double largestUnchanged;

  private final Sampler sampler;
  private final CameraRay ray = new CameraRay();
  private final Optional<SampleLayers> layers;
  private final RenderContext context;
  private final List<RenderStatistics.RejectedSample> firstRejected = new ArrayList<>();

  /** Increases with the samples; the {@link Watchdog} reads it. */
  private volatile long beats;

  private volatile Optional<Crop> bucket = Optional.empty();
  private long samples;
  private long nextQuestion;
  private long reported;
  private long rejected;
  private long saturated;
  private long invalidCoordinates;
  private long clamped;
  private double clampedLight;
  private long faint;

  /**
   * @param scene whose names and numbers the layers have
   * @param poses of the scene, a power of two
   */
  BucketRenderer(
      RenderSettings settings,
      Scene scene,
      List<TracedPose> poses,
      Sampler sampler,
      Film film,
      SampleTarget target,
      RenderQueue queue) {
    this.settings = settings;
    countsCoverage = settings.countsCoverage();
    blank = settings.background().orElse(Rgb.BLACK);
    this.poses = poses.toArray(TracedPose[]::new);
    this.film = film;
    this.target = target;
    this.queue = queue;
    limit = SampleLimit.of(settings);
    largestUnchanged = Math.min(settings.clamp(), Film.LARGEST);
    this.sampler = sampler;
    layers =
        film.layers().isEmpty()
            ? Optional.empty()
            : Optional.of(new SampleLayers(film.layers().stored(), scene));
    context = layers.map(RenderContext::collecting).orElseGet(RenderContext::new);
  }

  @Override
  public void run() {
    boolean returned = false;
    // Discard the count of earlier work of this thread.
    context.takeInvalidCoordinates();
    try {
      bucket = queue.take();
      while (bucket.isPresent() && render(bucket.get())) {
        queue.finish(bucket.get());
        bucket = queue.take();
      }
      returned = true;
    } finally {
      bucket = Optional.empty();
      invalidCoordinates = context.takeInvalidCoordinates();
      if (!returned) {
        queue.stop();
      }
    }
  }

  /** Renders a bucket; returns whether it is complete. */
  private boolean render(Crop bucket) {
    for (int y = bucket.y(); y < bucket.y() + bucket.height(); y++) {
      for (int x = bucket.x(); x < bucket.x() + bucket.width(); x++) {
        long before = rays();
        boolean isComplete = renderPixel(x, y);
        target.took(x, y, rays() - before);
        if (!isComplete) {
          return false;
        }
      }
    }
    report();
    return true;
  }

  private long rays() {
    return context.rays() + context.shadowRays();
  }

  private boolean renderPixel(int x, int y) {
    int pixel = film.index(x, y);
    int wanted = target.samples(x, y);
    // A pixel ends with equally many samples of each pose.
    for (int count = film.samples(pixel); count < wanted || !film.isWhole(count); count++) {
      if (samples - reported >= SAMPLES_PER_REPORT) {
        report();
      }
      if (samples >= nextQuestion && film.isWhole(count)) {
        beats = samples;
        nextQuestion = samples + SAMPLES_PER_QUESTION;
        if (queue.isStopped()) {
          return false;
        }
      }
      renderSample(x, y, film.firstSample() + count, pixel);
    }
    return true;
  }

  private void renderSample(int x, int y, int sample, int pixel) {
    context.startSample(settings.down(y));
    samples++;
    TracedPose pose = poses[sample & poses.length - 1];
    boolean hasRay = CameraSamples.start(pose.scene(), settings, sampler, x, y, sample, ray);
    Integrator integrator = pose.integrator();
    if (layers.isPresent()) {
      renderLayers(integrator, x, y, sample, pixel, hasRay, layers.get());
      return;
    }
    if (!hasRay) {
      film.add(pixel, blank, false);
      return;
    }
    Rgb radiance = accepted(integrator.radiance(ray, sampler, context), x, y, sample);
    film.add(pixel, radiance, context.hitSomething() || !countsCoverage);
  }

  private void renderLayers(
      Integrator integrator,
      int x,
      int y,
      int sample,
      int pixel,
      boolean hasRay,
      SampleLayers collected) {
    if (!hasRay) {
      collected.clear();
      film.add(pixel, blank, false, collected);
      return;
    }
    collected.start(ray);
    Rgb radiance = integrator.radiance(ray, sampler, context);
    Rgb kept = accepted(radiance, x, y, sample);
    if (kept != radiance) {
      collected.scaleLight(kept.isBlack() ? 0 : kept.max() / radiance.max());
    }
    collected.end(context.hitSomething());
    film.add(pixel, kept, context.hitSomething() || !countsCoverage, collected);
  }

  /** Returns the value to add to the film, and counts rejected, saturated and clamped samples. */
  private Rgb accepted(Rgb radiance, int x, int y, int sample) {
    if (SampleLimit.isRejected(radiance)) {
      rejected++;
      if (firstRejected.size() < MAX_REPORTED_REJECTS) {
        firstRejected.add(new RenderStatistics.RejectedSample(x, y, sample));
      }
      return Rgb.BLACK;
    }
    double largest = radiance.max();
    if (largest < Film.FAINT && largest > 0) {
      faint++;
    }
    return largest > largestUnchanged ? limited(radiance) : radiance;
  }

  private Rgb limited(Rgb radiance) {
    double largest = radiance.max();
    if (largest > Film.LARGEST) {
      saturated++;
    }
    if (largest > limit.clamp()) {
      clamped++;
      double kept = limit.clamp() / largest;
      clampedLight += (1 - kept) * (radiance.r() + radiance.g() + radiance.b()) / 3;
    }
    return limit.apply(radiance);
  }

  private void report() {
    queue.advance(samples - reported);
    reported = samples;
  }

  /** Returns a number that changes as samples end; any thread may call this. */
  long beats() {
    return beats;
  }

  /** Returns the current bucket; empty if there is none. Any thread may call this. */
  Optional<Crop> bucket() {
    return bucket;
  }

  RenderStatistics statistics() {
    return new RenderStatistics(
        samples,
        context.rays(),
        context.shadowRays(),
        rejected,
        firstRejected,
        saturated,
        invalidCoordinates,
        clamped,
        clampedLight,
        faint);
  }
}
