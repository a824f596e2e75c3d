/**
 * When a render has enough samples: estimates of a picture's error while it is rendered, and
 * budgets of samples, time and error that end the render.
 *
 * <p>{@link io.github.lumbre.stopping.BudgetRenderer} renders until a {@link
 * io.github.lumbre.stopping.Budget} is used up; {@link io.github.lumbre.stopping.NoiseEstimate}
 * bounds the error of what there is. All types but renderers and watches are immutable.
 */
package io.github.lumbre.stopping;
