/**
 * What the commands and the measurements share: exit codes and tasks that fail for a stated reason,
 * whole text files, and the version.
 */
package io.github.lumbre.base;
