/**
 * How fast this machine renders: timed renders, comparisons of two measurements, and paired
 * measurements of two settings.
 */
package io.github.lumbre.lab.perf;
