/**
 * The samplers, mappings and distributions behind {@link io.github.lumbre.math.sampling.Sampler},
 * which the module does not export.
 */
package io.github.lumbre.math.sampling.internal;
