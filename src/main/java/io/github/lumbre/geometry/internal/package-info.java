/** Parts of the geometry that the module does not export. */
package io.github.lumbre.geometry.internal;
