/**
 * Parsing of scene files: from JSON to a {@link io.github.lumbre.scene.Scene}.
 *
 * <p>Start with {@link io.github.lumbre.scenefile.SceneParser}; it returns a {@link
 * io.github.lumbre.scenefile.SceneFile}. Only this package handles the conventions of the format:
 * degrees, defaults, units of light and names. If a scene cannot be used, a {@link
 * io.github.lumbre.scenefile.SceneFormatException} lists the place of each error, what was found
 * and what was expected.
 */
@NullMarked
package io.github.lumbre.scenefile;

import org.jspecify.annotations.NullMarked;
