package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.dds.DdsFixture;
import io.github.lumbre.image.format.ktx.KtxSamples;
import io.github.lumbre.image.format.webp.WebpSamples;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelTexture;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which of its pictures a texture of glTF has. */
class GltfPicturesTest {
  private static final String MATERIAL =
      "{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}}}";
  private static final byte[] PNG = Pixels.of(1, 1, 1, new byte[] {7}).toPng();

  private final GltfFile file = new GltfFile();

  private Model model(byte[] picture, String texture) throws ModelFormatException, IOException {
    file.triangle(", 'material': 0");
    file.add("nodes", "{'mesh': 0}");
    file.add("materials", MATERIAL);
    file.add("images", "{'mimeType': 'image/ktx2', 'bufferView': " + file.view(picture, "") + "}");
    file.add("images", "{'mimeType': 'image/png', 'bufferView': " + file.view(PNG, "") + "}");
    file.add("textures", texture);
    return file.read();
  }

  private static Optional<byte[]> encoded(Model model) {
    Optional<ModelTexture> texture =
        model.parts().get(0).material().input(MaterialParameter.BASE_COLOR).texture();
    return texture.map(found -> found.image().encoded());
  }

  @ParameterizedTest
  @CsvSource({
    "KHR_texture_basisu, false, false",
    "KHR_texture_basisu, false, true",
    "KHR_texture_basisu, true, false",
    "KHR_texture_basisu, true, true",
    "EXT_texture_webp, false, true",
    "EXT_texture_webp, true, false",
    "MSFT_texture_dds, false, true",
    "MSFT_texture_dds, true, false"
  })
  void picturesOfExtensionsArePreferred(String extension, boolean isRequired, boolean hasOther)
      throws ModelFormatException, IOException {
    byte[] picture =
        switch (extension) {
          case "KHR_texture_basisu" -> KtxSamples.file("ETC1S of gray");
          case "EXT_texture_webp" -> WebpSamples.file("alpha-levels");
          default -> DdsFixture.named("DXT1", 40, 4, DdsFixture.data(1, 80));
        };
    file.set("extensionsUsed", "['" + extension + "']");
    if (isRequired) {
      file.set("extensionsRequired", "['" + extension + "']");
    }
    String other = hasOther ? ", 'source': 1" : "";
    Model model =
        model(picture, "{'extensions': {'" + extension + "': {'source': 0}}" + other + "}");
    assertThat(model.warnings()).isEmpty();
    assertThat(encoded(model)).contains(picture);
    assertThat(ImageReader.decode(picture).width()).isEqualTo(40);
  }

  @Test
  void otherPictureReplacesOneThatCannotBeRead() throws ModelFormatException, IOException {
    byte[] damaged = Arrays.copyOf(KtxSamples.file("UASTC"), 200);
    Model model =
        model(damaged, "{'extensions': {'KHR_texture_basisu': {'source': 0}}, 'source': 1}");
    assertThat(encoded(model)).contains(PNG);
  }

  @Test
  void damagedPictureWithoutAnotherIsLeftToItsUse() throws ModelFormatException, IOException {
    byte[] damaged = Arrays.copyOf(KtxSamples.file("UASTC"), 200);
    Model model = model(damaged, "{'extensions': {'KHR_texture_basisu': {'source': 0}}}");
    assertThat(encoded(model)).contains(damaged);
  }
}
