/**
 * Plants defects in copies of the renderer's classes and sees whether the tests find them: {@code
 * ./mvnw verify -Pmutants}.
 *
 * <p>{@link io.github.lumbre.mutants.Mutants} reads the defects, compiles each into classes of its
 * own, and lets {@link io.github.lumbre.mutants.NamedTests} run the tests that should fail, in
 * another process. The sources are never changed.
 */
package io.github.lumbre.mutants;

