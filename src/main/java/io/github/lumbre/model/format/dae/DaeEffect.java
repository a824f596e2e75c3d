package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The colors, pictures and numbers of an effect in its common profile (COLLADA 1.4.1, chapter 8).
 */
final class DaeEffect {
  static final Set<String> SHADERS = Set.of("lambert", "phong", "blinn", "constant");

  /** What is transparent by a color or a picture (COLLADA 1.4.1, chapter 7). */
  enum Transparency {
    A_ONE,
    RGB_ZERO,
    A_ZERO,
    RGB_ONE;

    /** Returns the opacity of a color, whose last component is alpha. */
    double opacity(double transparency, double... color) {
      // The weights of the specification (Recommendation ITU-R BT.709).
      double luminance = .212671 * color[0] + .71516 * color[1] + .072169 * color[2];
      return switch (this) {
        case A_ONE -> transparency * color[3];
        case A_ZERO -> 1 - transparency * color[3];
        case RGB_ZERO -> 1 - transparency * luminance;
        case RGB_ONE -> transparency * luminance;
      };
    }
  }

  private final DaeElement effect;
  private final DaeElement shader;
  private final DaeSamplers samplers;
  private final DaeDocument document;

  private DaeEffect(
      DaeElement effect, DaeElement shader, DaeSamplers samplers, DaeDocument document) {
    this.effect = effect;
    this.shader = shader;
    this.samplers = samplers;
    this.document = document;
  }

  /** Returns the effect of a material; empty, with a warning, if it has none that is known. */
  static Optional<DaeEffect> of(DaeElement material, DaeDocument document) {
    Optional<DaeElement> instance = material.find("instance_effect");
    Optional<DaeElement> effect =
        instance.flatMap(i -> document.find("effect", i.attribute("url"), i.location()));
    if (effect.isEmpty()) {
      return Optional.empty();
    }
    Optional<DaeElement> shader =
        effect.get().children("profile_COMMON").stream()
            .flatMap(profile -> profile.children("technique").stream())
            .flatMap(technique -> technique.children().stream())
            .filter(child -> SHADERS.contains(child.name()))
            .findFirst();
    if (shader.isEmpty()) {
      document
          .file()
          .warnings()
          .add(
              effect.get().location(),
              "expected <lambert>, <phong>, <blinn> or <constant> in <profile_COMMON>, found none;"
                  + " the material is replaced by light gray");
    }
    DaeSamplers samplers = new DaeSamplers(effect.get(), instance.get(), document);
    return shader.map(found -> new DaeEffect(effect.get(), found, samplers, document));
  }

  /** Returns whether the shader has a part, such as diffuse or specular. */
  boolean has(String part) {
    return shader.find(part).isPresent();
  }

  boolean is(String name) {
    return shader.is(name);
  }

  String location() {
    return shader.location();
  }

  /** Returns the color of a part: three components, and alpha, which is 1 if it is missing. */
  Optional<double[]> color(String part) {
    return shader
        .find(part)
        .flatMap(e -> e.find("color").or(() -> parameter(e)))
        .flatMap(e -> document.numbers(e, 3))
        .map(c -> new double[] {c[0], c[1], c[2], c.length > 3 ? c[3] : 1});
  }

  /** Returns a number of a part. */
  Optional<Double> number(String part) {
    return shader
        .find(part)
        .flatMap(e -> e.find("float").or(() -> parameter(e)))
        .flatMap(e -> document.numbers(e, 1))
        .map(found -> found[0]);
  }

  private Optional<DaeElement> parameter(DaeElement part) {
    return part.find("param")
        .flatMap(param -> samplers.parameter(param.attribute("ref")))
        .flatMap(param -> param.children().stream().findFirst());
  }

  /** Returns the picture of a part; empty if it has none that is found. */
  Optional<DaeTexture> texture(String part) {
    return shader.find(part, "texture").flatMap(samplers::texture);
  }

  /** Returns whether a part has a picture, found or not. */
  boolean hasTexture(String part) {
    return shader.find(part, "texture").isPresent();
  }

  Transparency transparency() {
    String stated = shader.find("transparent").map(e -> e.attribute("opaque")).orElse("");
    for (Transparency each : Transparency.values()) {
      if (each.name().equals(stated)) {
        return each;
      }
    }
    if (!stated.isEmpty()) {
      document
          .file()
          .warnings()
          .add(
              shader.location(),
              "expected A_ONE, A_ZERO, RGB_ONE or RGB_ZERO in opaque, found %s; A_ONE is used"
                  .formatted(PrintableText.quoted(stated)));
    }
    return Transparency.A_ONE;
  }

  /** Returns the picture of a bump or normal map, which extra elements state. */
  Optional<DaeTexture> bump() {
    for (DaeElement extra : extras()) {
      Optional<DaeElement> texture = extra.below("bump").flatMap(bump -> bump.find("texture"));
      if (texture.isPresent()) {
        return samplers.texture(texture.get());
      }
    }
    return Optional.empty();
  }

  /** Returns whether extra elements state that back faces are invisible. */
  boolean isOneSided() {
    return extras().stream()
        .flatMap(extra -> extra.below("double_sided").stream())
        .anyMatch(e -> e.text().equals("0"));
  }

  /** Returns whether the effect reflects colors of its own, which are no light. */
  boolean hasReflection() {
    boolean hasColor =
        color("reflective").map(c -> !new Rgb(c[0], c[1], c[2]).isBlack()).orElse(false);
    return (hasColor || hasTexture("reflective")) && number("reflectivity").orElse(1.) != 0;
  }

  private List<DaeElement> extras() {
    List<DaeElement> all = new ArrayList<>(shader.children("extra"));
    all.addAll(effect.children("extra"));
    for (DaeElement profile : effect.children("profile_COMMON")) {
      all.addAll(profile.children("extra"));
      profile.children("technique").forEach(t -> all.addAll(t.children("extra")));
    }
    return all;
  }
}
