package io.github.lumbre.scene;

import io.github.lumbre.geometry.SurfaceHit;

/**
 * What a ray met.
 *
 * @param emitter the primitive's index among {@link Scene#emitters}, or -1 if it is not sampled as
 *     a light
 */
public record Intersection(Primitive primitive, SurfaceHit surface, int emitter) {}
