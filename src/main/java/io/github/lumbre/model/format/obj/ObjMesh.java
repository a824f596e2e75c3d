package io.github.lumbre.model.format.obj;

/**
 * The content of an OBJ file as arrays. Corners with the same position, normal and texture
 * coordinates share one vertex. The arrays are not copied.
 *
 * @param positions three numbers per vertex
 * @param normals three numbers per vertex, or empty if the file has none
 * @param uvs two numbers per vertex, or empty if the file has none
 * @param indices three vertex numbers per triangle, from 0
 */
public record ObjMesh(double[] positions, double[] normals, double[] uvs, int[] indices) {}
