/**
 * Safe output files: written to a locked temporary file, and renamed when complete.
 *
 * <p>All output goes through {@link io.github.lumbre.file.OutputFile}; {@link
 * io.github.lumbre.file.FileFailure} words why reading or writing failed. The package is internal:
 * the module does not export it.
 */
package io.github.lumbre.file;
