/**
 * Invariants of the renderer at the extremes, measured: each {@link
 * io.github.lumbre.lab.checks.Invariant} states the range in which it was tried, the worst value
 * found, and the limit.
 *
 * <p>{@code lumbre selftest} and the tests measure the same invariants by the same code. All random
 * numbers come from fixed keys, so that every machine tries the same cases.
 */
package io.github.lumbre.lab.checks;
