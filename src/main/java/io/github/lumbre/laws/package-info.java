/**
 * The laws that the renderer obeys at the extremes, measured: each {@link
 * io.github.lumbre.laws.Law} tells over which range it was tried, the worst that was found, and
 * what it may be at most.
 *
 * <p>{@code lumbre selftest} and the tests measure the same laws by the same code. All is random by
 * fixed keys, so that on every machine the same is tried.
 */
package io.github.lumbre.laws;
