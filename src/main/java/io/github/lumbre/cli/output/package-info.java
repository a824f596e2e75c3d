/**
 * What the program writes: messages, progress, summaries, pictures, and the checks that no file is
 * overwritten by mistake.
 */
package io.github.lumbre.cli.output;
