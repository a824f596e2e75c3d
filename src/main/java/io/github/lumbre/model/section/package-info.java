/**
 * Cuts models by planes. The module does not export it. {@link
 * io.github.lumbre.model.section.Sections#cut} is the entry; a {@link
 * io.github.lumbre.model.section.Section} is what users state.
 *
 * <p>Each part of a model is cut in its own local space ({@link
 * io.github.lumbre.model.section.MeshCut}), so that its other vertices keep their bits. The lines
 * of its closed {@link io.github.lumbre.model.section.Shells} surround a {@link
 * io.github.lumbre.model.section.Cap}, which {@link io.github.lumbre.model.section.Outlines} fills
 * and a {@link io.github.lumbre.model.section.Hatch} paints.
 */
package io.github.lumbre.model.section;
