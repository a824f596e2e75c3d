/**
 * Installed programs that convert models which Lumbre cannot read into GLB. The module does not
 * export it: only a flag of the command line starts such a program.
 */
package io.github.lumbre.model.program;
