/**
 * Light transport: estimates of the radiance that arrives along a ray.
 *
 * <p>{@link io.github.lumbre.integrator.PathTracer} estimates all light up to a path length limit.
 * {@link io.github.lumbre.integrator.RayTracer} implements Whitted's ray tracing: direct light,
 * mirrors and glass. Both are immutable and shared by all threads; each thread has its own {@link
 * io.github.lumbre.integrator.RenderContext}. A {@link io.github.lumbre.integrator.PathRecorder}
 * records the vertices and contributions of a path, so that a sample can be explained.
 *
 * <p>A path tracer samples light by a list of techniques, each a {@code LightTechnique}, and
 * directions by a {@code DirectionStrategy}. It names none of them. What rays find by themselves is
 * in {@code FoundLights}. Recorders hear of each event as a {@code PathListener}.
 */
package io.github.lumbre.integrator;
