package io.github.lumbre.render;

import io.github.lumbre.image.Image;

/**
 * A picture and how it came about.
 *
 * @param complete false if the render was cancelled: pixels have fewer samples than asked for, and
 *     those without any are black
 */
public record RenderResult(Image image, boolean complete, RenderStatistics statistics) {}
