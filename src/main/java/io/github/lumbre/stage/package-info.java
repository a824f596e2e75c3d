/**
 * Models as scenes: a {@link io.github.lumbre.stage.StagedModel} is read from a file and stands on
 * a {@link io.github.lumbre.stage.Stage}, which has its camera, its light and its background.
 *
 * <p>The scene is built of what was read of the model, with the bits of the scene file that {@code
 * lumbre import} writes.
 */
@NullMarked
package io.github.lumbre.stage;

import org.jspecify.annotations.NullMarked;
