/**
 * Output of the program: messages, progress, summaries, pictures, and checks against accidental
 * overwriting of files.
 */
package io.github.lumbre.cli.output;
