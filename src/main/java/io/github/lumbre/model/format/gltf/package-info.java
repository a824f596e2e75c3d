/** Reads glTF 2.0 files, as JSON and as GLB, through {@link GltfReader}. */
package io.github.lumbre.model.format.gltf;
