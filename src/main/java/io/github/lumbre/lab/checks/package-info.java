/**
 * Measures invariants of the renderer at extreme values. Each {@link
 * io.github.lumbre.lab.checks.Invariant} states its tested range and its limit.
 *
 * <p>{@code lumbre selftest} and the tests measure the same invariants with the same code. All
 * random numbers come from fixed keys, so that every machine tests the same cases.
 */
package io.github.lumbre.lab.checks;
