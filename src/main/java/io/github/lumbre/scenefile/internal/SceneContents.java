package io.github.lumbre.scenefile.internal;

/**
 * The number of objects and assets in a scene and its models.
 *
 * @param camera the camera type's name in the scene format
 * @param shapes number of spheres, planes, cubes, mesh instances and parts of models
 * @param meshes number of meshes in use; instances share one
 * @param triangles number of triangles over all mesh instances, each instance counted
 * @param points number of points of models, each instance counted
 * @param lights number of lights of all types
 * @param materials number of materials in use, without default materials
 * @param textures number of textures and of pictures of models in use
 */
public record SceneContents(
    String camera,
    int shapes,
    int meshes,
    long triangles,
    long points,
    int lights,
    int materials,
    int textures) {}
