/**
 * JSON texts as trees whose values know their paths: of scene files, and of glTF files.
 *
 * <p>{@link io.github.lumbre.base.json.JsonTree} reads a text, {@link
 * io.github.lumbre.base.json.JsonValue} is a value of it. What a value must be is the matter of the
 * readers of scenes and models.
 */
package io.github.lumbre.base.json;
