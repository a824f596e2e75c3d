/**
 * Decodes bytes that meshoptimizer has compressed, versions 0 and 1 of the bitstream. The module
 * does not export it. {@link io.github.lumbre.model.format.meshopt.MeshoptMode#decode} is the
 * entry, {@link io.github.lumbre.model.format.meshopt.MeshoptFilter} what follows.
 *
 * <p>A stream has a header of one byte, data, and a tail of fixed size. {@link
 * io.github.lumbre.model.format.meshopt.AttributesDecoder} restores elements from their
 * differences, {@link io.github.lumbre.model.format.meshopt.TrianglesDecoder} triangles from the
 * edges before them, and {@link io.github.lumbre.model.format.meshopt.IndicesDecoder} numbers from
 * the numbers before them.
 *
 * <p>Names and steps are those of the glTF extension <a
 * href="https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Khronos/KHR_meshopt_compression">
 * KHR_meshopt_compression</a>, appendices A and B. All integer arithmetic wraps around.
 */
package io.github.lumbre.model.format.meshopt;
