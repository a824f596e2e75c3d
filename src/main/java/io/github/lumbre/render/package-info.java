/**
 * From a scene to a picture: buckets, threads, film and progress.
 *
 * <p>{@link io.github.lumbre.render.BucketRenderer} divides the film into buckets, which threads
 * take from a queue; a {@link io.github.lumbre.render.Film} sums samples exactly, so that no order
 * of work changes a bit; a {@link io.github.lumbre.render.Progress} hears what is done and may
 * cancel.
 */
package io.github.lumbre.render;
