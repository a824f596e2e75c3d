package io.github.lumbre.render;

/**
 * The result of a pass over a film.
 *
 * @param complete false if the pass was cancelled; some pixels then have fewer samples than their
 *     target
 * @param statistics the statistics of this pass
 */
public record PassResult(boolean complete, RenderStatistics statistics) {}
