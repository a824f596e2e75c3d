/** The masks of lenses, and the matrices of cameras, which the module does not export. */
package io.github.lumbre.camera.internal;
