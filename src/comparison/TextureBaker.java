import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.sampling.internal.Hash;
import io.github.lumbre.texture.internal.CloudTexture;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import io.github.lumbre.texture.internal.WoodTexture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes the procedural textures of a scene as pictures, ID.png each, so that every renderer can
 * read them: {@code TextureBaker SCENE.json FOLDER}. Values are those of the scene's seed 0.
 */
final class TextureBaker {
  private TextureBaker() {}

  public static void main(String[] args) throws IOException {
    JsonObject scene = JsonParser.parseString(Files.readString(Path.of(args[0]))).getAsJsonObject();
    for (JsonElement asset : scene.getAsJsonArray("assets")) {
      JsonObject texture = asset.getAsJsonObject();
      if (isProcedural(texture)) {
        Path file = Path.of(args[1], texture.get("id").getAsInt() + ".png");
        Files.write(file, picture(procedural(texture)).toPng());
      }
    }
  }

  private static boolean isProcedural(JsonObject asset) {
    return asset.has("textureType") && !asset.get("textureType").getAsString().equals("Image");
  }

  private static TexelTexture procedural(JsonObject texture) {
    long seed = Hash.of(Hash.mix(0), texture.get("id").getAsInt());
    int width = texture.get("width").getAsInt();
    int height = texture.get("height").getAsInt();
    return switch (texture.get("textureType").getAsString()) {
      case "Wood" -> new WoodTexture(seed, width, height, texture.get("rings").getAsDouble());
      case "Marble" -> new MarbleTexture(seed, width, height);
      case "Cloud" -> new CloudTexture(seed, width, height, 128);
      case "Voronoi" ->
          new VoronoiTexture(
              seed, width, height, texture.get("samples").getAsInt(), texture.has("blackAndWhite"));
      default -> throw new IllegalArgumentException("no such texture: " + texture);
    };
  }

  private static Image picture(TexelTexture texture) {
    int width = texture.width();
    int height = texture.height();
    float[] rgb = new float[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      Rgb texel = texture.texel(i % width, i / width);
      rgb[3 * i] = (float) texel.r();
      rgb[3 * i + 1] = (float) texel.g();
      rgb[3 * i + 2] = (float) texel.b();
    }
    return new Image(width, height, rgb, new float[0]);
  }
}
