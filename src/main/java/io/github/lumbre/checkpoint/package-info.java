/**
 * Films in files: kept while a render runs, continued, joined and developed afterwards.
 *
 * <p>A {@link io.github.lumbre.checkpoint.FilmFile} is a film with a {@link
 * io.github.lumbre.checkpoint.FilmHeader} that states what its samples depend on;
 * docs/film-format.md describes its bytes. A {@link io.github.lumbre.checkpoint.CheckpointFile} is
 * where a running render saves it again and again, and {@link
 * io.github.lumbre.checkpoint.Checkpoints} says when. A {@link
 * io.github.lumbre.checkpoint.FilmMerge} joins films of one picture.
 */
package io.github.lumbre.checkpoint;
