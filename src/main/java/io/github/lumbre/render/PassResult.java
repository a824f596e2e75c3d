package io.github.lumbre.render;

/**
 * What a pass over a film did.
 *
 * @param complete false if the pass was cancelled: some pixels have fewer samples than they should
 */
public record PassResult(boolean complete, RenderStatistics statistics) {}
