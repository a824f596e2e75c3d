/**
 * Checkpoint files: films that are saved while a render runs, and resumed, merged or developed
 * afterwards.
 *
 * <p>A {@link io.github.lumbre.render.checkpoint.FilmFile} is a film with a {@link
 * io.github.lumbre.render.checkpoint.FilmHeader} that states everything on which its samples
 * depend; docs/film-format.md describes its bytes. A running render saves its film to a {@link
 * io.github.lumbre.render.checkpoint.CheckpointFile}, at the intervals that {@link
 * io.github.lumbre.render.checkpoint.internal.Checkpoints} controls. {@link
 * io.github.lumbre.render.checkpoint.FilmMerge} merges films of one picture.
 */
@NullMarked
package io.github.lumbre.render.checkpoint;

import org.jspecify.annotations.NullMarked;
