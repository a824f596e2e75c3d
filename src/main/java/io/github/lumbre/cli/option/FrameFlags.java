package io.github.lumbre.cli.option;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneParser;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that set the size of the picture. */
@Command(optionListHeading = Headings.FRAME)
public final class FrameFlags extends Flags {
  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description =
          "Size of the full frame in pixels, or its longer side (scene or 1920x1080; models: 1024"
              + " for the longer side, with the aspect ratio of the camera, or 1024x768).")
  private Optional<FrameSize> size;

  /** The size without a flag; empty for that of the scene. */
  private Optional<FrameSize> usual = Optional.empty();

  @Option(
      names = "--crop",
      paramLabel = "x,y,w,h",
      description = "Render only this window of the full frame, with the same pixel values.")
  private Optional<Crop> crop;

  @Option(
      names = "--max-pixels",
      paramLabel = "N",
      description = "Reject frames with more pixels (268435456, which is 2^28).")
  private Optional<Integer> maxPixels;

  /**
   * Checks the ranges of the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    maxPixels.ifPresent(n -> checks().requireIn("--max-pixels", 1, SceneParser.MAX_PIXELS_EVER, n));
    size.ifPresent(checks()::requireSize);
    size.ifPresent(s -> s.height().ifPresent(height -> requireCropIn(s.width(), height)));
  }

  private void requireCropIn(int width, int height) {
    Crop window = crop.orElse(new Crop(0, 0, 1, 1));
    require(
        (long) window.x() + window.width() <= width
            && (long) window.y() + window.height() <= height,
        "--crop: expected a part of " + width + "x" + height + ", found " + window);
  }

  /** Sets the size without a flag. */
  void unlessGiven(FrameSize newUsual) {
    usual = Optional.of(newUsual);
  }

  /** Returns a parser that limits the number of pixels. */
  public SceneParser over(SceneParser parser) {
    return maxPixels.map(parser::limitedTo).orElse(parser);
  }

  public void override(RenderSettings.Builder builder, RenderSettings inScene) {
    RenderSettings sized = size.or(() -> usual).map(s -> s.over(inScene)).orElse(inScene);
    builder.size(sized.width(), sized.height());
    requireCropIn(sized.width(), sized.height());
    crop.ifPresent(builder::crop);
  }
}
