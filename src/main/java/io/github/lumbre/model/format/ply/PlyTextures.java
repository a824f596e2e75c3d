package io.github.lumbre.model.format.ply;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.format.ObjTextures;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.UvTransform;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntUnaryOperator;

/**
 * The pictures that the comments {@code TextureFile} of a PLY file name, as tools for scans write
 * them: the color of the surface, instead of the colors of vertices.
 */
final class PlyTextures {
  private static final String LOCATION = "comment TextureFile";

  private final List<Optional<ModelTexture>> textures = new ArrayList<>();

  /**
   * Reads the pictures. Those that cannot be read are left out with a warning.
   *
   * @param names of the files, in the order of the file
   */
  PlyTextures(List<String> names, ModelFiles files, ModelOptions options, Warnings warnings)
      throws ModelFormatException, IOException {
    ObjTextures pictures = new ObjTextures(files, options.limits());
    for (String name : names) {
      MtlMap map =
          new MtlMap(LOCATION, MtlMap.portable(name), -1, 1, Wrap.REPEAT, UvTransform.IDENTITY);
      boolean isReadable = pictures.isReadable(map, warnings);
      textures.add(isReadable ? Optional.of(pictures.texture(map)) : Optional.empty());
    }
  }

  boolean isPresent() {
    return textures.stream().anyMatch(Optional::isPresent);
  }

  /**
   * Returns the parts of a mesh: one for each texture.
   *
   * @param plain the material of triangles without a picture
   * @param texture returns the number of the texture of a triangle
   */
  List<ModelPart> parts(
      ModelGeometry mesh, ModelMaterial plain, IntUnaryOperator texture, ModelOptions options) {
    List<ModelPart> parts = new ArrayList<>();
    ModelNode whole = ModelNode.undivided("");
    for (int i = 0; i <= textures.size(); i++) {
      int[] indices = triangles(mesh.indices(), texture, i);
      if (indices.length > 0) {
        Optional<ModelTexture> picture = i < textures.size() ? textures.get(i) : Optional.empty();
        parts.add(
            new ModelPart(
                whole,
                "",
                of(mesh, picture.isPresent() ? new float[0] : mesh.colors(), indices),
                picture.map(PlyTextures::material).orElse(plain),
                options.toWorld()));
      }
    }
    return parts;
  }

  /** Returns the triangles of a texture; of all other numbers for that after the last one. */
  private int[] triangles(int[] indices, IntUnaryOperator texture, int number) {
    TriangleList list = new TriangleList(0);
    for (int i = 0; i < indices.length; i += 3) {
      int stated = textures.size() == 1 ? 0 : texture.applyAsInt(indices[i]);
      int used = stated < 0 ? textures.size() : Math.min(stated, textures.size());
      if (used == number) {
        list.add(indices[i], indices[i + 1], indices[i + 2]);
      }
    }
    return list.toArray();
  }

  private static ModelGeometry of(ModelGeometry mesh, float[] colors, int... indices) {
    return new ModelGeometry(
        mesh.positions(), mesh.normals(), mesh.tangents(), mesh.uv0(), mesh.uv1(), colors, indices);
  }

  private static ModelMaterial material(ModelTexture texture) {
    return PlainModel.matte("", "")
        .set(MaterialParameter.BASE_COLOR, new MaterialInput(Rgb.WHITE, Optional.of(texture), 0))
        .alphaMode(AlphaMode.OPAQUE)
        .build();
  }
}
