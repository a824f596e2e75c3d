/**
 * Lights and light sampling.
 *
 * <p>Sampling a {@link io.github.lumbre.light.Light} at a point gives a {@link
 * io.github.lumbre.light.LightSample}: a direction, and the light that arrives from there if
 * nothing blocks it. Lights do not know the scene; integrators trace the shadow ray. Rays can also
 * hit an {@link io.github.lumbre.light.AreaLight} or an {@link
 * io.github.lumbre.light.EnvironmentLight}. These two return the density with which light sampling
 * would have drawn that ray.
 *
 * <p>Radiance is linear RGB, densities are per solid angle at the lit point, and positions and
 * directions are in world space.
 */
@NullMarked
package io.github.lumbre.light;

import org.jspecify.annotations.NullMarked;
