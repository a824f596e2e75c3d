package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.UvTransform;

/**
 * A picture of a material.
 *
 * @param map the file
 * @param semantic the name that instances bind to a set of texture coordinates; may be empty
 */
record DaeTexture(
    MtlMap map, String semantic, Wrap wrapU, Wrap wrapV, boolean nearest, UvTransform transform) {}
