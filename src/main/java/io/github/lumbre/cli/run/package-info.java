/** A render as the command line runs it: budget, checkpoints, signals, progress. */
package io.github.lumbre.cli.run;
