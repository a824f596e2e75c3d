/**
 * The samplers, mappings and distributions behind {@link io.github.lumbre.sampling.Sampler}, which
 * the module does not export.
 */
package io.github.lumbre.sampling.internal;
