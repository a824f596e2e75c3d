package io.github.lumbre.stopping;

import io.github.lumbre.render.RenderStatistics;
import java.util.Optional;

/**
 * The result of a render within a budget.
 *
 * @param complete false if the render was cancelled before it reached a limit of the budget
 * @param reachedTarget whether the target error was reached
 * @param noise noise estimate of the picture; empty if a pixel has fewer than two samples
 * @param statistics counts of the samples that this render added
 */
public record BudgetResult(
    boolean complete,
    boolean reachedTarget,
    Optional<NoiseEstimate> noise,
    RenderStatistics statistics) {}
