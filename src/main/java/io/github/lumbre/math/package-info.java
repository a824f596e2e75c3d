/**
 * Points, vectors, rays, frames, transforms, bounds, and elementary functions that are
 * bit-identical on every machine.
 *
 * <p>Start at {@link io.github.lumbre.math.Vec3}. A {@link io.github.lumbre.math.Ray} consists of
 * two, a {@link io.github.lumbre.math.Frame} of three, and a {@link
 * io.github.lumbre.math.Transform} places an object in the world.
 *
 * <p>World space is <b>left-handed</b>: +x right, +y up, +z forward. Positions and directions are
 * both {@code Vec3}; names distinguish them. Angles are in radians unless a name contains {@code
 * degrees} or {@code turns}.
 *
 * <p>All types are immutable and safe for use by any thread. This package depends on no other
 * package.
 */
@NullMarked
package io.github.lumbre.math;

import org.jspecify.annotations.NullMarked;
