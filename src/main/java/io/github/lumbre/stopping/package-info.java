/**
 * Adaptive stopping: budgets of samples and error that end a render, and error estimates of a
 * picture while it is rendered.
 *
 * <p>{@link io.github.lumbre.stopping.BudgetRenderer} renders until a limit of a {@link
 * io.github.lumbre.stopping.Budget} is reached. {@link io.github.lumbre.stopping.NoiseEstimate}
 * bounds the error of the current picture. All types except {@link
 * io.github.lumbre.stopping.BudgetWatch} are immutable or, like the internal estimator, confined to
 * one call.
 */
package io.github.lumbre.stopping;
