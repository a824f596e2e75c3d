package io.github.lumbre.render;

import io.github.lumbre.image.Image;

/**
 * A rendered picture and the statistics of its render.
 *
 * @param complete false if the render was cancelled; pixels then have fewer samples than the
 *     settings, and pixels without samples are black
 */
public record RenderResult(Image image, boolean complete, RenderStatistics statistics) {}
