/** Recorded light paths as plain data: the result of replaying a pixel. */
package io.github.lumbre.path;
