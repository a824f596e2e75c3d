/**
 * Who emits light, and how to sample it.
 *
 * <p>A {@link io.github.lumbre.light.Light} answers a point with a {@link
 * io.github.lumbre.light.LightSample}: a direction to look in, and the light that arrives from
 * there if nothing is in between. Lights never see the scene; integrators trace the shadow ray.
 * {@link io.github.lumbre.light.AreaLight} and {@link io.github.lumbre.light.EnvironmentLight} can
 * also be hit by a ray, and say with which density they would have been sampled there.
 *
 * <p>Radiance in linear RGB; densities per solid angle at the lit point; world space.
 */
package io.github.lumbre.light;

