package io.github.lumbre.render.preview;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.render.stopping.NoiseEstimate;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The picture of a render at one moment. Immutable, and independent of the film: a listener may
 * keep it and pass it to other threads.
 *
 * @param image the mean of the samples so far; pixels without samples are black
 * @param layers the layers that the listener wants, among those that the render records
 * @param samples the mean number of samples per pixel
 * @param totalSamples the number of samples of all pixels
 * @param isEndOfPass whether all pixels have the samples of a pass; otherwise some pixels have more
 *     samples than others
 * @param noise the estimate of the picture's error; empty if the listener does not want it, within
 *     a pass, or with fewer than two samples per pixel
 * @param metadata attributes that describe the layers in an OpenEXR file, by name
 */
public record Preview(
    Image image,
    List<ImageLayer> layers,
    double samples,
    long totalSamples,
    boolean isEndOfPass,
    Optional<NoiseEstimate> noise,
    Map<String, String> metadata) {
  public Preview {
    layers = List.copyOf(layers);
    metadata = Collections.unmodifiableMap(new LinkedHashMap<>(metadata));
  }
}
