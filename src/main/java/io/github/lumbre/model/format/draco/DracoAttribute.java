package io.github.lumbre.model.format.draco;

import java.nio.ByteBuffer;

/**
 * A decoded attribute of a mesh.
 *
 * @param id by which a file that contains the stream refers to the attribute
 * @param type of the numbers
 * @param components numbers per point
 * @param isNormalized whether integers are fractions of their largest value
 * @param values of all points, little-endian, without gaps
 */
public record DracoAttribute(
    long id, DracoType type, int components, boolean isNormalized, ByteBuffer values) {}
