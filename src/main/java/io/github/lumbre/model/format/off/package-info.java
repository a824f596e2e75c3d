/** Reads OFF texts through {@link OffReader}. */
package io.github.lumbre.model.format.off;
