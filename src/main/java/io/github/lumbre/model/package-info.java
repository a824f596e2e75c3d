/**
 * Models from files: glTF 2.0, OBJ with MTL, PLY, STL, OFF, 3MF and COLLADA, also in ZIP archives. {@link
 * io.github.lumbre.model.Models} reads a {@link io.github.lumbre.model.ModelFile}, which scenes
 * that are built in code place. Each format has a package here, which the module does not export;
 * {@code draco} and {@code meshopt} decode compressed data of glTF files.
 */
@NullMarked
package io.github.lumbre.model;

import org.jspecify.annotations.NullMarked;
