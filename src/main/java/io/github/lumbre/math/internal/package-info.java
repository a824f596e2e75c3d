/**
 * The parts of {@link io.github.lumbre.math} that the module does not export: elementary functions
 * with the same bits everywhere, hashes, and ranges of numbers.
 */
package io.github.lumbre.math.internal;
