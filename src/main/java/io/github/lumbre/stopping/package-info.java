/**
 * Adaptive stopping: budgets of samples and error that end a render, and error estimates of a
 * picture while it is rendered.
 *
 * <p>A {@link io.github.lumbre.stopping.BudgetWatch} ends the passes of a {@link
 * io.github.lumbre.render.PassLoop} at the target error of a {@link
 * io.github.lumbre.stopping.Budget}. {@link io.github.lumbre.stopping.NoiseEstimate} bounds the
 * error of the current picture. All types except {@link io.github.lumbre.stopping.BudgetWatch} are
 * immutable or, like the internal estimator, confined to one call.
 */
@NullMarked
package io.github.lumbre.stopping;

import org.jspecify.annotations.NullMarked;
