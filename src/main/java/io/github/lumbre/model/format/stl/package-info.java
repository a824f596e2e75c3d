/** Reads STL files, as text and binary, through {@link StlReader}. */
package io.github.lumbre.model.format.stl;
