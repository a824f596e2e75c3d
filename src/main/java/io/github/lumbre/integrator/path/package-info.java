/** Recorded light paths as plain data: the result of replaying a pixel. */
@NullMarked
package io.github.lumbre.integrator.path;

import org.jspecify.annotations.NullMarked;
