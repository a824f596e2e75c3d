/**
 * Pictures of models for servers: {@link io.github.lumbre.stage.thumbnail.Thumbnails} takes the
 * bytes of a model and gives the bytes of a picture.
 */
@NullMarked
package io.github.lumbre.stage.thumbnail;

import org.jspecify.annotations.NullMarked;
