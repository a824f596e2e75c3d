/** Pictures of errors, which the module does not export. */
package io.github.lumbre.compare.internal;
