/**
 * Renders scenes to pictures: buckets, threads, films and progress.
 *
 * <p>{@link io.github.lumbre.render.BucketRenderer} renders a scene to a picture in several passes.
 * Each pass of a {@link io.github.lumbre.render.FilmRenderer} divides the film into buckets, which
 * threads take from a queue, and adds samples to their pixels. A {@link
 * io.github.lumbre.render.Film} sums samples exactly, so that the result is bit-identical for any
 * order of work. A {@link io.github.lumbre.render.Progress} receives progress and can cancel.
 * {@link io.github.lumbre.render.PixelReplay} repeats single samples.
 */
package io.github.lumbre.render;
