package io.github.lumbre.parser;

/**
 * How much of everything a scene holds.
 *
 * @param camera the format's name of the camera's type
 * @param shapes spheres, planes, cubes and placed meshes
 * @param meshes mesh assets in use
 * @param triangles over all placed meshes, each placement counted
 * @param lights of all types
 * @param materials in use
 * @param textures in use
 */
public record SceneContents(
    String camera,
    int shapes,
    int meshes,
    long triangles,
    int lights,
    int materials,
    int textures) {}
