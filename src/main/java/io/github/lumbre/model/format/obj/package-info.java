/** Reads OBJ files with their material libraries (MTL), through {@link ObjModelReader}. */
package io.github.lumbre.model.format.obj;
