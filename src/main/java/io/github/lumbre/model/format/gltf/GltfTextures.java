package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.EncodedFormat;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelImage;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.UvTransform;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** The textures, samplers and images of a glTF file (glTF 2.0, section 3.8). Mutable. */
final class GltfTextures {
  /** Extensions that give a texture a picture in another format, the preferred one first. */
  static final List<String> PICTURES =
      List.of("KHR_texture_basisu", "EXT_texture_webp", "MSFT_texture_dds");

  private static final int NEAREST = 9728;
  private static final int CLAMP_TO_EDGE = 33071;
  private static final int MIRRORED_REPEAT = 33648;
  private static final int REPEAT = 10497;

  private final GltfDocument document;
  private final GltfBuffers buffers;
  private final boolean mayLackFiles;
  private final GltfValues values;
  private final Map<Integer, Optional<ModelImage>> images = new HashMap<>();

  /**
   * @param mayLackFiles whether a texture whose image cannot be read is left out with a warning
   */
  GltfTextures(GltfDocument document, GltfBuffers buffers, boolean mayLackFiles) {
    this.document = document;
    this.buffers = buffers;
    this.mayLackFiles = mayLackFiles;
    values = new GltfValues(document.warnings(), "texture");
  }

  /**
   * Returns the texture that a member of an object names; empty if there is none, or none that is
   * supported.
   */
  Optional<ModelTexture> read(GltfJson object, String member)
      throws ModelFormatException, IOException {
    Optional<GltfJson> info = values.object(object, member);
    return info.isPresent() ? read(info.get()) : Optional.empty();
  }

  private Optional<ModelTexture> read(GltfJson info) throws ModelFormatException, IOException {
    List<GltfJson> textures = document.section("textures");
    GltfJson texture = textures.get(info.requireIndex("index", textures.size()));
    Optional<GltfJson> transform = values.extension(info, "KHR_texture_transform");
    long uvSet = info.whole("texCoord", 0, 0, Integer.MAX_VALUE);
    if (transform.isPresent()) {
      uvSet = transform.get().whole("texCoord", uvSet, 0, Integer.MAX_VALUE);
    }
    List<Integer> sources = sources(texture);
    if (uvSet > 1 || sources.isEmpty()) {
      String what =
          uvSet > 1
              ? "TEXCOORD_" + uvSet + " is not supported"
              : "expected a picture, found " + unknownSource(texture);
      document
          .warnings()
          .add("a texture is left out", info.location(), what + "; the texture is left out");
      return Optional.empty();
    }
    Optional<ModelImage> image = usable(sources);
    if (image.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        sampled(
            texture,
            image.get(),
            (int) uvSet,
            transform.isPresent() ? transform(transform.get()) : UvTransform.IDENTITY));
  }

  /** Returns the indices of the images of a texture, the preferred one first. */
  private List<Integer> sources(GltfJson texture) throws ModelFormatException {
    int images = document.size("images");
    List<Integer> sources = new ArrayList<>();
    for (String name : PICTURES) {
      Optional<GltfJson> extension = texture.extension(name);
      if (extension.isPresent()) {
        extension.get().index("source", images).ifPresent(sources::add);
      }
    }
    texture.index("source", images).ifPresent(sources::add);
    return sources;
  }

  /** Returns the first of some images that can be read; if there is none, the last. */
  private Optional<ModelImage> usable(List<Integer> sources)
      throws ModelFormatException, IOException {
    for (int source : sources.subList(0, sources.size() - 1)) {
      Optional<ModelImage> image = usable(source);
      if (image.isPresent() && isIntact(image.get())) {
        return image;
      }
    }
    return usable(sources.get(sources.size() - 1));
  }

  private static boolean isIntact(ModelImage image) {
    try {
      EncodedFormat.open(image.encoded(), Limits.NONE);
      return true;
    } catch (ImageFormatException e) {
      return false;
    }
  }

  /** Returns the extensions that give a texture a picture in another format. */
  private static String unknownSource(GltfJson texture) throws ModelFormatException {
    Optional<GltfJson> extensions = texture.object("extensions");
    return extensions.isEmpty() || extensions.get().keys().isEmpty()
        ? "none"
        : PrintableText.shortened(String.join(", ", extensions.get().keys()));
  }

  private ModelTexture sampled(GltfJson texture, ModelImage image, int uvSet, UvTransform transform)
      throws ModelFormatException {
    List<GltfJson> samplers = document.section("samplers");
    OptionalInt index = texture.index("sampler", samplers.size());
    if (index.isEmpty()) {
      return new ModelTexture(image, uvSet, Wrap.REPEAT, Wrap.REPEAT, false, transform);
    }
    GltfJson sampler = samplers.get(index.getAsInt());
    return new ModelTexture(
        image,
        uvSet,
        wrap(sampler, "wrapS"),
        wrap(sampler, "wrapT"),
        values.number(sampler, "magFilter", 0) == NEAREST,
        transform);
  }

  private Wrap wrap(GltfJson sampler, String member) {
    double code = values.number(sampler, member, REPEAT);
    if (code == MIRRORED_REPEAT) {
      return Wrap.MIRROR;
    }
    if (code == CLAMP_TO_EDGE) {
      return Wrap.CLAMP;
    }
    if (code != REPEAT) {
      values.replaced(
          sampler.location(member),
          "33071, 33648 or 10497",
          PrintableText.number(code),
          Integer.toString(REPEAT));
    }
    return Wrap.REPEAT;
  }

  /**
   * Returns a transform of KHR_texture_transform, for v = 0 at the lower edge. There u' = ou +
   * cos·su·u + sin·sv·v and v' = ov - sin·su·u + cos·sv·v, with v = 0 at the upper edge; here v and
   * v' are replaced with 1 - v and 1 - v'.
   */
  private UvTransform transform(GltfJson json) {
    double[] offset = values.numbers(json, "offset", 0, 0);
    double[] scale = values.numbers(json, "scale", 1, 1);
    double turns = values.number(json, "rotation", 0) / Elementary.TWO_PI;
    double sin = Elementary.sinTurns(turns);
    double cos = Elementary.cosTurns(turns);
    return new UvTransform(
        cos * scale[0],
        -sin * scale[1],
        offset[0] + sin * scale[1],
        sin * scale[0],
        cos * scale[1],
        1 - offset[1] - cos * scale[1]);
  }

  /** Returns an image; empty, with a warning, if it cannot be read and need not exist. */
  private Optional<ModelImage> usable(int index) throws ModelFormatException, IOException {
    Optional<ModelImage> image = images.get(index);
    if (image == null) {
      image = image(document.section("images").get(index));
      images.put(index, image);
    }
    return image;
  }

  private Optional<ModelImage> image(GltfJson json) throws ModelFormatException, IOException {
    try {
      return Optional.of(new ModelImage(json.location(), encoded(json)));
    } catch (ModelFormatException e) {
      if (!mayLackFiles || e.kind() != Kind.ASSET) {
        throw e;
      }
      document
          .warnings()
          .add("a picture is left out", e.location(), e.detail() + "; the picture is left out");
      return Optional.empty();
    }
  }

  private byte[] encoded(GltfJson json) throws ModelFormatException, IOException {
    return json.has("uri") ? buffers.load(json) : buffers.copyOfView(json);
  }
}
