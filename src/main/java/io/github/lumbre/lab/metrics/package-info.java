/**
 * Statistics of measurements: confidence intervals of means, medians and ratios, and the noise of
 * pictures. All types are immutable or stateless, and thread-safe.
 */
package io.github.lumbre.lab.metrics;
