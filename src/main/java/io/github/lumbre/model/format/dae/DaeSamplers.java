package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.UvTransform;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Finds the pictures that an effect uses: by a sampler and its surface (COLLADA 1.4), by a sampler
 * and its instance of an image (1.5), or by the id of the image itself, as some programs write it.
 */
final class DaeSamplers {
  private static final Map<String, Wrap> WRAPS =
      Map.of("MIRROR", Wrap.MIRROR, "CLAMP", Wrap.CLAMP, "BORDER", Wrap.CLAMP, "NONE", Wrap.CLAMP);

  private final DaeDocument document;

  /** The parameters of the effect, and of its instance, by their names. */
  private final Map<String, DaeElement> parameters = new HashMap<>();

  /**
   * @param effect with its parameters at its technique, its profile or itself
   * @param instance of the effect, whose parameters win
   */
  DaeSamplers(DaeElement effect, DaeElement instance, DaeDocument document) {
    this.document = document;
    addParameters(effect);
    effect.find("profile_COMMON").ifPresent(this::addParameters);
    effect.find("profile_COMMON", "technique").ifPresent(this::addParameters);
    for (DaeElement stated : instance.children("setparam")) {
      parameters.put(stated.attribute("ref"), stated);
    }
  }

  private void addParameters(DaeElement parent) {
    parent.children("newparam").forEach(param -> parameters.put(param.attribute("sid"), param));
  }

  /** Returns a parameter of the effect or its instance. */
  Optional<DaeElement> parameter(String name) {
    return Optional.ofNullable(parameters.get(name));
  }

  /** Returns the picture of a {@code <texture>}; empty, with a warning, if none is found. */
  Optional<DaeTexture> texture(DaeElement use) {
    String name = use.attribute("texture");
    Optional<DaeElement> sampler = parameter(name).flatMap(DaeSamplers::sampler);
    Optional<DaeElement> image =
        sampler.isPresent() ? imageOf(sampler.get()) : surfaceImage(name, use);
    DaeElement settings = sampler.orElse(use);
    UvTransform transform = transform(use);
    return image
        .flatMap(this::file)
        .map(
            file ->
                new DaeTexture(
                    new MtlMap(use.location(), file, -1, 1, Wrap.REPEAT, UvTransform.IDENTITY),
                    use.attribute("texcoord"),
                    wrap(settings, "wrap_s"),
                    wrap(settings, "wrap_t"),
                    settings.find("magfilter").filter(e -> e.text().equals("NEAREST")).isPresent(),
                    transform));
  }

  private static Optional<DaeElement> sampler(DaeElement parameter) {
    return parameter.children().stream().filter(e -> e.name().startsWith("sampler")).findFirst();
  }

  private Optional<DaeElement> imageOf(DaeElement sampler) {
    Optional<DaeElement> instance = sampler.find("instance_image");
    if (instance.isPresent()) {
      return document.find("image", instance.get().attribute("url"), sampler.location());
    }
    String surface = sampler.find("source").map(DaeElement::text).orElse("");
    return surfaceImage(surface, sampler);
  }

  /** Returns the image of a surface, or that of the name itself. */
  private Optional<DaeElement> surfaceImage(String name, DaeElement use) {
    Optional<DaeElement> from =
        parameter(name).flatMap(parameter -> parameter.find("surface", "init_from"));
    String id = from.map(e -> e.find("ref").orElse(e).text()).orElse(name);
    return document
        .withId("image", id)
        .or(() -> document.imageOfName(id))
        .or(() -> document.find("image", id, use.location()));
  }

  /** Returns the name of an image's file; empty, with a warning, if its bytes are in this file. */
  private Optional<String> file(DaeElement image) {
    Optional<DaeElement> from = image.find("init_from");
    Optional<String> uri =
        from.map(e -> e.find("ref").orElse(e).text()).filter(text -> !text.isEmpty());
    if (uri.isEmpty()) {
      document
          .file()
          .warnings()
          .add(
              image.location(),
              "expected the file of a picture in <init_from>, found none; the picture is left out");
    }
    return uri.map(DaeUri::fileName);
  }

  private Wrap wrap(DaeElement sampler, String direction) {
    String stated = sampler.find(direction).map(DaeElement::text).orElse("WRAP");
    if (stated.equals("BORDER")) {
      document
          .file()
          .warnings()
          .once(" border", sampler.location(), "colors of borders are left out");
    }
    return WRAPS.getOrDefault(stated, Wrap.REPEAT);
  }

  /** Returns the map of texture coordinates that Maya's extra elements state. */
  private UvTransform transform(DaeElement use) {
    if (number(use, "rotateUV", 0) != 0 || number(use, "rotateFrame", 0) != 0) {
      document
          .file()
          .warnings()
          .once(" rotated", use.location(), "rotations of textures are left out");
    }
    return new UvTransform(
        number(use, "repeatU", 1),
        0,
        number(use, "offsetU", 0),
        0,
        number(use, "repeatV", 1),
        number(use, "offsetV", 0));
  }

  private double number(DaeElement use, String name, double otherwise) {
    Function<DaeElement, Optional<double[]>> number = e -> document.numbers(e, 1);
    List<DaeElement> extras = use.children("extra");
    Optional<DaeElement> stated = extras.stream().flatMap(e -> e.below(name).stream()).findFirst();
    return stated.flatMap(number).map(found -> found[0]).orElse(otherwise);
  }
}
