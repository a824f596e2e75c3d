/** The masks of lenses, which the module does not export. */
package io.github.lumbre.camera.internal;
