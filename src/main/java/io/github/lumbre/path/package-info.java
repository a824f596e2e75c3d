/** Recorded light paths, as plain data: what the replay of a pixel returns. */
package io.github.lumbre.path;
