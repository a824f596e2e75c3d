/**
 * Scene files: from JSON to objects.
 *
 * <p>{@link io.github.lumbre.parser.SceneParser} is the entrance and {@link
 * io.github.lumbre.parser.SceneFile} what comes out. Everything that belongs to the format and not
 * to rendering (degrees, defaults, rules of radiance, names) is translated here and nowhere else. A
 * scene that cannot be used ends in a {@link io.github.lumbre.parser.SceneFormatException} that
 * states the place, what was found and what was expected.
 */
package io.github.lumbre.parser;
