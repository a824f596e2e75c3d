package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * Limits on what a stream may contain, checked before memory is allocated.
 *
 * @param faces the largest number of faces
 * @param points the largest number of points of a mesh with sequential connectivity; other meshes
 *     have at most three per face
 * @param memory counts the bytes that are about to be allocated
 */
public record DracoLimits(long faces, long points, Memory memory) {
  @FunctionalInterface
  public interface Memory {
    /**
     * Adds bytes that are about to be allocated.
     *
     * @throws ModelFormatException if the sum exceeds a limit
     */
    void allocate(long bytes) throws ModelFormatException;
  }
}
