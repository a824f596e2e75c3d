package io.github.lumbre.stopping;

import io.github.lumbre.render.RenderStatistics;
import java.util.Optional;

/**
 * How a render within a budget ended.
 *
 * @param complete false if it was cancelled before it had all samples or the error
 * @param reachedTarget whether the target error was reached
 * @param noise of the picture; empty if a pixel has fewer than two samples
 */
public record BudgetResult(
    boolean complete,
    boolean reachedTarget,
    Optional<NoiseEstimate> noise,
    RenderStatistics statistics) {}
