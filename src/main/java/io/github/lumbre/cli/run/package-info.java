/** Runs renders for the command line: budget, checkpoints, signals, progress. */
package io.github.lumbre.cli.run;
