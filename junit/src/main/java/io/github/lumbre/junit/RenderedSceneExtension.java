package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.extension.ParameterResolver;

/** Renders pictures for parameters; see {@link RenderedScene}. Stateless. */
public final class RenderedSceneExtension implements ParameterResolver {
  private static final ExtensionContext.Namespace PICTURES =
      ExtensionContext.Namespace.create(RenderedSceneExtension.class);

  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int SAMPLES = 16;

  /** Creates the extension; JUnit does. */
  public RenderedSceneExtension() {}

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    return parameter.getParameter().getType() == Image.class && found(parameter).isPresent();
  }

  private static Optional<RenderedScene> found(ParameterContext parameter) {
    return parameter
        .findAnnotation(RenderedScene.class)
        .or(
            () ->
                Optional.ofNullable(
                    parameter.getDeclaringExecutable().getAnnotation(RenderedScene.class)));
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    RenderedScene wanted = found(parameter).orElseThrow();
    // Annotations with the same values are equal.
    return context
        .getRoot()
        .getStore(PICTURES)
        .getOrComputeIfAbsent(wanted, RenderedSceneExtension::picture, Image.class);
  }

  static Image picture(RenderedScene wanted) {
    try {
      SceneFile file = read(wanted, path(wanted.value()));
      return wanted.denoise()
          ? BuiltInDenoiser.render(file.settings(), file.scene(), Progress.NONE)
          : new PictureRenderer(file.settings()).render(file.scene());
    } catch (SceneFormatException | IllegalArgumentException e) {
      throw failure(wanted, e.getMessage(), e);
    } catch (IOException e) {
      throw failure(wanted, e.toString(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw failure(wanted, "interrupted", e);
    }
  }

  private static ParameterResolutionException failure(
      RenderedScene wanted, String message, Exception cause) {
    return new ParameterResolutionException(
        "@RenderedScene(\"" + wanted.value() + "\"): " + message, cause);
  }

  private static Path path(String name) {
    Path direct = Path.of(name);
    Path resource = Path.of("src/test/resources").resolve(name);
    return Files.exists(direct) || !Files.exists(resource) ? direct : resource;
  }

  private static SceneFile read(RenderedScene wanted, Path path)
      throws SceneFormatException, IOException {
    boolean isModel = Models.isModel(path);
    SceneParser parser =
        new SceneParser().overriding(settings -> overridden(settings, wanted, isModel));
    if (isModel) {
      return StagedModel.read(path, stage(wanted), parser).scene();
    }
    if (!wanted.view().isEmpty() || wanted.ground() || !wanted.up().isEmpty()) {
      throw new IllegalArgumentException("view, ground, up: expected a model, found a scene");
    }
    return parser.parse(path);
  }

  private static RenderSettings overridden(
      RenderSettings settings, RenderedScene wanted, boolean isModel) {
    int width = isModel ? WIDTH : settings.width();
    int height = isModel ? HEIGHT : settings.height();
    int samples = isModel ? SAMPLES : settings.samples();
    return settings.toBuilder()
        .size(
            wanted.width() == 0 ? width : wanted.width(),
            wanted.height() == 0 ? height : wanted.height())
        .samples(wanted.samples() == 0 ? samples : wanted.samples())
        .build();
  }

  private static ModelOptions.Up up(RenderedScene wanted) {
    return switch (wanted.up()) {
      case "y" -> ModelOptions.Up.Y;
      case "z" -> ModelOptions.Up.Z;
      default -> throw new IllegalArgumentException("up: expected y or z, found " + wanted.up());
    };
  }

  private static Stage stage(RenderedScene wanted) {
    Stage stage = Stage.DEFAULT;
    if (!wanted.up().isEmpty()) {
      Optional<ModelOptions.Up> up = Optional.of(up(wanted));
      stage = stage.reading(ModelOptions.DEFAULT.oriented(up, OptionalDouble.empty()));
    }
    if (!wanted.view().isEmpty()) {
      stage = stage.seenFrom(Stage.View.of(wanted.view()));
    }
    return stage.with(Stage.GROUND, wanted.ground());
  }
}
