/** The page of {@code lumbre diff}: pictures of two models, and a table of what changed. */
package io.github.lumbre.cli.diff;
