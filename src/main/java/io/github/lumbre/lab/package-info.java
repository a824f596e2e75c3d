/**
 * Classes shared by all measurements of the lab.
 *
 * <p>A {@link io.github.lumbre.lab.Trial} renders one setting with one seed and returns its picture
 * and {@link io.github.lumbre.lab.Cost}. {@link io.github.lumbre.lab.Pairs} compares two settings
 * by alternating trials. A {@link io.github.lumbre.lab.Table} writes results as Markdown, CSV, JSON
 * or HTML.
 */
package io.github.lumbre.lab;
