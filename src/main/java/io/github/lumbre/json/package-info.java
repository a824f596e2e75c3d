/**
 * JSON texts as trees whose values know their paths: of scene files, and of glTF files.
 *
 * <p>{@link io.github.lumbre.json.JsonTree} reads a text, {@link io.github.lumbre.json.JsonValue} is
 * a value of it. What a value must be is the matter of the readers of scenes and models.
 */
package io.github.lumbre.json;
