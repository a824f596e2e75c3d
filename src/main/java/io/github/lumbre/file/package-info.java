/**
 * Files that are replaced as a whole: written beside their name, locked, and renamed when complete.
 *
 * <p>{@link io.github.lumbre.file.OutputFile} is the one way to write, {@link
 * io.github.lumbre.file.FileFailure} the one place that words why it failed. The package is
 * internal: the module does not export it.
 */
package io.github.lumbre.file;
