/**
 * Adaptive stopping: budgets of samples and error that end a render, and error estimates of a
 * picture while it is rendered.
 *
 * <p>A {@link io.github.lumbre.render.stopping.BudgetWatch} ends the passes of a {@link
 * io.github.lumbre.render.PassLoop} at the target error of a {@link
 * io.github.lumbre.render.stopping.Budget}. {@link io.github.lumbre.render.stopping.NoiseEstimate}
 * bounds the error of the current picture. All types except {@link
 * io.github.lumbre.render.stopping.BudgetWatch} are immutable or, like the internal estimator,
 * confined to one call.
 */
@NullMarked
package io.github.lumbre.render.stopping;

import org.jspecify.annotations.NullMarked;
