/** Saves of checkpoint files during a render, and the pictures of films. Not exported. */
package io.github.lumbre.render.checkpoint.internal;
