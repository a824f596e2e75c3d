/**
 * Decodes KTX 2 files with textures of Basis Universal, as glTF's KHR_texture_basisu uses them, or
 * of 8 bits per channel. The module does not export it. {@link
 * io.github.lumbre.image.format.ktx.KtxFile} is the entry.
 *
 * <p>A file has levels; the first one, the largest, is decoded. Its texels come in blocks of 4x4
 * ({@link io.github.lumbre.image.format.ktx.TexelBlocks}). In UASTC, each block has 16 bytes, which
 * {@link io.github.lumbre.image.format.ktx.UastcBlock} decodes. In ETC1S, blocks refer to two code
 * books, {@link io.github.lumbre.image.format.ktx.Etc1sCodeBooks}, in streams of Huffman codes,
 * which {@link io.github.lumbre.image.format.ktx.Etc1sSlice} decodes. Values are those that the
 * Basis Universal transcoder gives as RGBA.
 *
 * <p>Sources: KTX File Format 2.0 (Khronos), its appendix BasisLZ/ETC1S Bitstream Specification,
 * the Khronos Data Format Specification 1.3, and the UASTC LDR 4x4 Texture Specification
 * (Binomial).
 */
package io.github.lumbre.image.format.ktx;
