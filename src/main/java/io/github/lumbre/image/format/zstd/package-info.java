/**
 * Decodes Zstandard, which compresses textures in KTX files (RFC 8878). The module does not export
 * it. {@link io.github.lumbre.image.format.zstd.Zstandard#decode} is the entry.
 *
 * <p>A frame consists of blocks. A compressed block has literals, decoded by {@link
 * io.github.lumbre.image.format.zstd.Literals}, and sequences, decoded by {@link
 * io.github.lumbre.image.format.zstd.Sequences}: each copies some literals, and then bytes that
 * were written before. Literals have a Huffman code, numbers of sequences are coded by finite state
 * entropy ({@link io.github.lumbre.image.format.zstd.EntropyTable}).
 */
package io.github.lumbre.image.format.zstd;
