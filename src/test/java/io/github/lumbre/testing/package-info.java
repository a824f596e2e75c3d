/**
 * What the tests share: significance tests, and a sampler that says what it is told.
 *
 * <p>How long a test tries, and from which seed, {@link io.github.lumbre.testing.Effort} says:
 * every build is quick and repeats itself, {@code ./mvnw verify -Pexhaustive} takes its time and
 * new seeds.
 *
 * <p>A law about an average is checked by {@link io.github.lumbre.testing.Moments#z}, a law about a
 * density by {@link io.github.lumbre.testing.ChiSquare}; both at {@link
 * io.github.lumbre.testing.Statistics#ALPHA}. In a quick build seeds are fixed, so a test passes or
 * fails forever; how small a defect it finds is {@link
 * io.github.lumbre.testing.Statistics#samplesToDetect}'s to say, and belongs into the test.
 */
package io.github.lumbre.testing;
