/**
 * Pictures of models for servers: {@link io.github.lumbre.thumbnail.Thumbnails} takes the bytes of a
 * model and gives the bytes of a picture.
 */
@NullMarked
package io.github.lumbre.thumbnail;

import org.jspecify.annotations.NullMarked;
