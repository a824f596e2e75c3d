package io.github.lumbre.integrator;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/** The techniques that sample the light of a scene. Immutable. */
final class LightTechniques {
  /** Next-event estimation, which weights environment lights even where it is not listed. */
  final DirectLights direct;

  /** Whether any light is sampled. */
  final boolean isOn;

  final LightTechnique[] ofCamera;

  /** The techniques of non-specular vertices, in the order in which they are used. */
  final LightTechnique[] ofVertices;

  final LightTechnique[] all;

  /** Whether some technique needs to know the specular surfaces that a path has met. */
  private final boolean needsLinks;

  LightTechniques(LightSampling shared) {
    direct = new DirectLights(shared);
    isOn = shared.isOn();
    ofCamera = isOn ? list(Stream.of(LensLights.of(shared))) : new LightTechnique[0];
    ofVertices =
        isOn
            ? list(
                Stream.of(Optional.of(direct), RefractedLights.of(shared), MirrorLights.of(shared)))
            : new LightTechnique[0];
    all = Stream.of(ofCamera, ofVertices).flatMap(Arrays::stream).toArray(LightTechnique[]::new);
    needsLinks = ofVertices.length > 1;
  }

  private static LightTechnique[] list(Stream<Optional<? extends LightTechnique>> techniques) {
    return techniques.flatMap(Optional::stream).toArray(LightTechnique[]::new);
  }

  /** Notes the direction in which the path leaves a vertex, before its throughput changes. */
  void leave(Vertex vertex, RenderContext context) {
    if (needsLinks) {
      context.link.leave(vertex, context.path.throughput(), context.hit, context.scratch.scattered);
    }
  }
}
