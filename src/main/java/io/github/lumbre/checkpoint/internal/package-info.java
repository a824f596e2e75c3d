/** Checkpoints that are saved while a render goes on, and the pictures of films. Not exported. */
package io.github.lumbre.checkpoint.internal;
