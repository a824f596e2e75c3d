/** Parts of scenes and settings that the module does not export. */
package io.github.lumbre.scene.internal;
