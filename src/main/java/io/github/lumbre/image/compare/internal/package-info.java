/** Pictures of errors, which the module does not export. */
package io.github.lumbre.image.compare.internal;
