/** The parts of {@link io.github.lumbre.math} that the module does not export: elementary functions with the
 * same bits everywhere, and hashes. */
package io.github.lumbre.math.internal;
