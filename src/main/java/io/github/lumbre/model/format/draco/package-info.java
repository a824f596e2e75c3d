/**
 * Decodes meshes that Draco has compressed, version 2.2 of the bitstream. The module does not
 * export it. {@link io.github.lumbre.model.format.draco.DracoMesh#decode} is the entry.
 *
 * <p>A stream has a header, the connectivity of the triangles, and the values of the attributes.
 * {@link io.github.lumbre.model.format.draco.SequentialConnectivity} reads a list of corners;
 * {@link io.github.lumbre.model.format.draco.EdgebreakerConnectivity} rebuilds a {@link
 * io.github.lumbre.model.format.draco.CornerTable} from one symbol per triangle. {@link
 * io.github.lumbre.model.format.draco.AttributesDecoder} then decodes the attributes, each as
 * corrections of a {@link io.github.lumbre.model.format.draco.Prediction}.
 *
 * <p>A <em>corner</em> 3 f + k is corner k of face f, and stands for the edge opposite to it. A
 * <em>vertex</em> is a place in the connectivity of one attribute, an <em>entry</em> one value of
 * the attribute, and a <em>point</em> a vertex of the decoded mesh: a combination of entries.
 *
 * <p>Names and steps are those of the <a href="https://google.github.io/draco/spec/">Draco
 * Bitstream Specification</a>, version 2.2; where it is silent, Google's decoder 1.5 decides. The
 * traversal is described in J. Rossignac, Edgebreaker: Connectivity Compression for Triangle
 * Meshes, IEEE TVCG 1999, and M. Isenburg and J. Snoeyink, Spirale Reversi, 2001.
 *
 * <p>All integer arithmetic wraps around, as in Google's decoder.
 */
package io.github.lumbre.model.format.draco;
