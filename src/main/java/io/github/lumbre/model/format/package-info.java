/** What readers of several formats share: XML, ZIP archives, and textures named as in MTL files. */
package io.github.lumbre.model.format;
