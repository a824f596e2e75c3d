/**
 * Path guiding: a learned distribution of the directions in which light arrives (Müller, Gross,
 * Novák 2017, "Practical Path Guiding for Efficient Light-Transport Simulation").
 *
 * <p>{@link io.github.lumbre.integrator.guiding.GuideRecords} holds what a pilot render found.
 * {@link io.github.lumbre.integrator.guiding.GuideBuilder} makes a {@link
 * io.github.lumbre.integrator.guiding.Guide} of it: a binary tree over positions, whose leaves are
 * quadtrees over directions. {@link io.github.lumbre.integrator.guiding.Connections} adds
 * directions to bright places. {@link io.github.lumbre.integrator.guiding.CellFraction} chooses how
 * many directions follow it in each cell. After that, a guide never changes, and all threads share
 * it. Positions and directions are in world space. Densities are per solid angle.
 */
package io.github.lumbre.integrator.guiding;
