/**
 * Hostile scenes, made from sound ones by a seed: {@link io.github.lumbre.fuzz.SceneMutator}
 * changes the tree of a scene, {@link io.github.lumbre.fuzz.PictureMutator} and {@link
 * io.github.lumbre.fuzz.MeshMutator} the files inside it, and {@link
 * io.github.lumbre.fuzz.HostileScenes} reads and renders what comes out and judges how it ended.
 */
package io.github.lumbre.fuzz;
