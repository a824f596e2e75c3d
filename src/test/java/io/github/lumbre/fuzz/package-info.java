/**
 * Hostile scenes, derived from valid ones by a seed. {@link io.github.lumbre.fuzz.SceneMutator}
 * changes the tree of a scene; {@link io.github.lumbre.fuzz.PictureMutator} and {@link
 * io.github.lumbre.fuzz.MeshMutator} change the files inside it. {@link
 * io.github.lumbre.fuzz.HostileScenes} reads and renders the result and checks how it ended.
 */
package io.github.lumbre.fuzz;
