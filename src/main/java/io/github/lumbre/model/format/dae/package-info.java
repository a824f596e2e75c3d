/**
 * Reads COLLADA files through {@link DaeReader}: {@link DaeParser} makes a tree of elements, {@link
 * DaeScene} walks its nodes, {@link DaeGeometry} has the surfaces of a mesh, and {@link
 * DaeMaterials} their materials.
 */
package io.github.lumbre.model.format.dae;
