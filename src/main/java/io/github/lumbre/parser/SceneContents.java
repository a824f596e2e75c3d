package io.github.lumbre.parser;

/**
 * The number of objects and assets in a scene.
 *
 * @param camera the camera type's name in the scene format
 * @param shapes number of spheres, planes, cubes and mesh instances
 * @param meshes number of mesh assets in use
 * @param triangles number of triangles over all mesh instances, each instance counted
 * @param lights number of lights of all types
 * @param materials number of materials in use
 * @param textures number of textures in use
 */
public record SceneContents(
    String camera,
    int shapes,
    int meshes,
    long triangles,
    int lights,
    int materials,
    int textures) {}
