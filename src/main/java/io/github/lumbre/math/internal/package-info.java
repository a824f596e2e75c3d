/** The parts of {@link io.github.lumbre.math} that the module does not export: elementary functions with the same bits everywhere. */
package io.github.lumbre.math.internal;
