/**
 * Readers of model files: glTF 2.0, OBJ with MTL, PLY and STL. {@link
 * io.github.lumbre.model.ModelReader} chooses the reader and returns a {@link
 * io.github.lumbre.model.Model}, which does not depend on the format.
 */
package io.github.lumbre.model;
