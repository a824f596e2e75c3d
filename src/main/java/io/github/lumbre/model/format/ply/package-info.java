/** Reads PLY files, as text and binary, through {@link PlyReader}. */
package io.github.lumbre.model.format.ply;
