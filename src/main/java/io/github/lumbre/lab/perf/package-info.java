/**
 * Measurements of rendering speed: timed renders, comparisons of two measurements, and paired
 * measurements of two settings.
 */
package io.github.lumbre.lab.perf;
