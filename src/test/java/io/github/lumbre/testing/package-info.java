/**
 * Shared test helpers: significance tests, a sampler with given values, and checks of refusals.
 *
 * <p>{@link io.github.lumbre.testing.Effort} sets the number of samples and the seed of a test.
 * Normal builds are quick and repeatable; {@code ./mvnw verify -Pexhaustive} uses more samples and
 * new seeds.
 *
 * <p>Use {@link io.github.lumbre.testing.Moments#z} to test means and {@link
 * io.github.lumbre.testing.ChiSquare} to test densities, both at {@link
 * io.github.lumbre.testing.Statistics#ALPHA}. In a quick build, seeds are fixed, so a test always
 * passes or always fails. State in each test the smallest error that it detects; {@link
 * io.github.lumbre.testing.Statistics#samplesToDetect} computes the number of samples for it.
 */
package io.github.lumbre.testing;
