/**
 * Renders scenes to pictures: passes, buckets, threads, films and progress.
 *
 * <p>{@link io.github.lumbre.render.PictureRenderer} renders a scene to a picture. A {@link
 * io.github.lumbre.render.PassLoop} renders a film, pass by pass, until it is complete or a {@link
 * io.github.lumbre.render.StopRule} ends it. {@link io.github.lumbre.render.FilmRenderer} renders
 * the passes: it divides the film into buckets, which threads take from a queue, and adds samples
 * to their pixels. A {@link io.github.lumbre.render.Film} sums samples exactly, so that the result
 * is bit-identical for any order of work. A {@link io.github.lumbre.render.Progress} receives
 * progress and can cancel. {@link io.github.lumbre.render.PixelReplay} repeats single samples.
 */
@NullMarked
package io.github.lumbre.render;

import org.jspecify.annotations.NullMarked;
