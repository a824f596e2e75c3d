/**
 * From a scene to a picture: buckets, threads, film and progress.
 *
 * <p>{@link io.github.lumbre.render.BucketRenderer} turns a scene into a picture. It passes over
 * the picture again and again; each pass of a {@link io.github.lumbre.render.FilmRenderer} divides
 * the film into buckets, which threads take from a queue, and adds samples to their pixels. A
 * {@link io.github.lumbre.render.Film} sums samples exactly, so that no order of work changes a
 * bit; a {@link io.github.lumbre.render.Progress} hears what is done and may cancel. {@link
 * io.github.lumbre.render.PixelReplay} repeats single samples.
 */
package io.github.lumbre.render;

