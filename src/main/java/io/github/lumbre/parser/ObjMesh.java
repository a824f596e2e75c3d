package io.github.lumbre.parser;

/**
 * The content of an OBJ file, as arrays: corners that agree in position, normal and texture
 * coordinates are one vertex. The arrays are not copied.
 *
 * @param positions three numbers a vertex
 * @param normals three numbers a vertex, or empty if the file has none
 * @param uvs two numbers a vertex, or empty if the file has none
 * @param indices three vertices a triangle
 */
record ObjMesh(double[] positions, double[] normals, double[] uvs, int[] indices) {}
