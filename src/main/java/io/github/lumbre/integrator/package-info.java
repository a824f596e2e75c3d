/**
 * Light transport: the radiance that arrives along a ray.
 *
 * <p>{@link io.github.lumbre.integrator.PathTracer} estimates all of it, up to a depth; {@link
 * io.github.lumbre.integrator.RayTracer} is Whitted's: direct light, mirrors and glass. Both are
 * stateless and shared by all threads; each thread has its own {@link
 * io.github.lumbre.integrator.RenderContext}. A {@link io.github.lumbre.integrator.PathRecorder}
 * listens to the steps of a path and explains how a sample came about.
 */
package io.github.lumbre.integrator;

