/**
 * Joins rendered frames into one animation file.
 *
 * <p>{@link io.github.lumbre.image.animation.AnimationFormat} knows the formats by the endings of
 * names. {@link io.github.lumbre.image.animation.AnimationFrames} are the frames, PNG files that
 * are read one at a time.
 */
package io.github.lumbre.image.animation;
