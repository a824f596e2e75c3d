/**
 * Light transport: the radiance that arrives along a ray.
 *
 * <p>{@link io.github.lumbre.integrator.PathTracer} estimates all of it, up to a depth; {@link
 * io.github.lumbre.integrator.RayTracer} is Whitted's: direct light, mirrors and glass. Both are
 * stateless and shared by all threads. A {@link io.github.lumbre.integrator.Recorder} is either of
 * them and remembers the last path, for one thread that wants to know how a sample came about.
 */
package io.github.lumbre.integrator;
