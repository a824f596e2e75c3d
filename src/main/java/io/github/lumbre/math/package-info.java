/**
 * Points, vectors, rays, frames, transforms, bounds, and elementary functions that give the same
 * bits on every machine.
 *
 * <p>Start at {@link io.github.lumbre.math.Vec3}; a {@link io.github.lumbre.math.Ray} is two of
 * them, a {@link io.github.lumbre.math.Frame} three, and a {@link io.github.lumbre.math.Transform}
 * places an object in the world.
 *
 * <p>World space is <b>left-handed</b>: +x right, +y up, +z forward. Positions and directions are
 * both {@code Vec3}; names distinguish them. Angles are radians unless a name says {@code degrees}.
 *
 * <p>All types here are immutable and so safe for use by any thread. Nothing here depends on
 * another package.
 */
package io.github.lumbre.math;
