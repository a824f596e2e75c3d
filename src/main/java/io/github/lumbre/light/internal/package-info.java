/**
 * The choice of a light to sample, which the module does not export. {@link
 * io.github.lumbre.light.internal.LightSampler} chooses one of few lights by its estimated
 * contribution, one of many by a tree over them.
 */
package io.github.lumbre.light.internal;
