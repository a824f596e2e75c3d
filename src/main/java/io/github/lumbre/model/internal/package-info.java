/**
 * Readers of model files: glTF 2.0, OBJ with MTL, PLY and STL. The module does not export them.
 * {@link io.github.lumbre.model.internal.ModelReader} chooses the reader and returns a {@link
 * io.github.lumbre.model.internal.Model}, which does not depend on the format.
 */
package io.github.lumbre.model.internal;
