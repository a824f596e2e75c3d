/** Depths and passes of renders, which the module does not export. */
package io.github.lumbre.render.internal;
