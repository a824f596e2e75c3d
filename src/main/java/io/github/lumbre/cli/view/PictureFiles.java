package io.github.lumbre.cli.view;

import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.Visible;
import io.github.lumbre.image.Dither;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Makes the files that the browser saves: the picture as PNG with the look of the page, or as
 * OpenEXR with layers.
 *
 * @param viewed the path of the file that is viewed
 * @param automatic the automatic exposure of a picture that is not rendered here
 * @param background the background of a picture that is not rendered here
 */
record PictureFiles(Path viewed, Exposure automatic, Optional<Rgb> background) {
  private static final long MOST_STOPS = 64;

  Answer of(Frame frame, Optional<SceneFile> scene, ViewSession session, Query query)
      throws IOException {
    boolean isExr = query.text("format").equals(Optional.of("exr"));
    Frame shown = ViewRoutes.isDenoised(query) && !isExr ? frame.denoised().orElse(frame) : frame;
    Map<String, String> metadata =
        scene.map(file -> metadata(shown, file, session)).orElseGet(LinkedHashMap::new);
    metadata.putAll(shown.metadata());
    ImageWriter.Options options =
        new ImageWriter.Options(exposure(frame, scene, query), curve(query), 8, metadata)
            .withBackground(scene.map(s -> s.settings().background()).orElse(background))
            .withDither(
                scene
                    .map(s -> s.settings().window().dither())
                    .or(() -> Optional.of(Dither.FULL_FRAME)));
    String file = String.valueOf(viewed.getFileName());
    String stem = file.contains(".") ? file.substring(0, file.lastIndexOf('.')) : file;
    if (isExr) {
      return Answer.file(stem + ".exr", "image/x-exr", exr(frame, options));
    }
    return Answer.file(stem + ".png", "image/png", shown.image().toPng(options));
  }

  private Map<String, String> metadata(Frame frame, SceneFile file, ViewSession session) {
    Snapshot state = session.snapshot();
    Map<String, String> metadata =
        PictureMetadata.of(viewed, file, file.settings(), state.seconds());
    boolean isOpen = file.settings().samples() == RenderSettings.MAX_SAMPLES;
    if (!isOpen && frame.samples() < file.settings().samples()) {
      metadata.put(
          "Partial",
          String.format(
              Locale.ROOT,
              "%.1f of %d samples per pixel",
              frame.samples(),
              file.settings().samples()));
    }
    session
        .moved()
        .ifPresent(camera -> metadata.put("Camera", camera.pose().toString()));
    return metadata;
  }

  Exposure automatic(Frame frame, Optional<SceneFile> scene) {
    return scene
        .map(file -> Visible.exposure(Exposure.AUTO, file, frame.image()))
        .orElse(automatic);
  }

  private Exposure exposure(Frame frame, Optional<SceneFile> scene, Query query) {
    return query.text("exposure").equals(Optional.of("auto"))
        ? automatic(frame, scene)
        : Exposure.of(query.decimal("exposure", -MOST_STOPS, MOST_STOPS, 0));
  }

  private static ToneCurve curve(Query query) {
    String text = query.text("tone").orElse(ToneCurve.SRGB.label());
    return ToneCurve.of(text)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "tone: expected one of %s, found %s"
                        .formatted(
                            Arrays.stream(ToneCurve.values())
                                .map(ToneCurve::label)
                                .collect(Collectors.joining(", ")),
                            text)));
  }

  private static byte[] exr(Frame frame, ImageWriter.Options options) throws IOException {
    Path folder = Files.createTempDirectory("lumbre-view-");
    Path file = folder.resolve("picture.exr");
    try {
      ImageWriter.write(frame.image(), frame.layers(), file, options);
      return Files.readAllBytes(file);
    } finally {
      for (Path path : List.of(file, folder)) {
        Files.deleteIfExists(path);
      }
    }
  }
}
