/**
 * Safe output files, written to a locked temporary file and renamed when complete, and installed
 * programs.
 *
 * <p>All output goes through {@link io.github.lumbre.base.file.OutputFile}; {@link
 * io.github.lumbre.base.file.FileFailure} words why reading or writing failed. {@link
 * io.github.lumbre.base.file.ExternalProgram} runs a program within a time limit. The package is
 * internal: the module does not export it.
 */
package io.github.lumbre.base.file;
