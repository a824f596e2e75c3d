package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.compare.internal.ErrorMap;
import io.github.lumbre.image.internal.ImageFormat;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Measures how much two pictures differ. */
record CompareTool(Roots roots, Limits limits) implements Tool {
  private static final Input<String> PICTURE =
      Input.requiredText("picture", "Path of a PNG, JPEG, EXR, HDR, PFM or other picture.");

  private static final Input<String> REFERENCE =
      Input.requiredText("reference", "Path of a picture of the same size.");

  /** So that the map is no larger than what language models take. */
  private static final long MOST_PIXELS = 1L << 21;

  @Override
  public String name() {
    return "compare";
  }

  @Override
  public String title() {
    return "Compare two pictures";
  }

  @Override
  public String description() {
    return "Measures how much a picture differs from another one of the same size: flip (0: same,"
        + " 1: largest visible difference), ssim (1: same), rmse and others in linear light,"
        + " and a PNG map of each pixel's relative error: black up to 0.001, purple 0.01,"
        + " orange 0.1, pale yellow from 1.";
  }

  @Override
  public List<Input<?>> inputs() {
    return List.of(PICTURE, REFERENCE);
  }

  @Override
  public List<Output> outputs() {
    return List.of(
        Output.number("rmse", "Root of the mean squared error, in linear light."),
        Output.number("relmse", "Mean squared error, relative to the reference."),
        Output.number("bias", "Mean of the picture less the reference."),
        Output.number("p99.9", "99.9th percentile of the absolute error."),
        Output.number("max", "Largest absolute error."),
        Output.number("ssim", "Structural similarity: 1 for the same picture."),
        Output.number("flip", "Visible difference: 0 for the same picture, at most 1."));
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress) throws ToolException {
    Image picture = read(arguments.get(PICTURE));
    Image reference = read(arguments.get(REFERENCE));
    if (picture.width() != reference.width() || picture.height() != reference.height()) {
      throw new ToolException(
          "picture, reference: expected the same size, found %dx%d and %dx%d"
              .formatted(picture.width(), picture.height(), reference.width(), reference.height()));
    }
    Map<String, Object> values = new LinkedHashMap<>(PictureError.of(picture, reference).byName());
    byte[] map =
        ImageFormat.PNG.bytes(ErrorMap.of(picture, reference), ImageWriter.Options.ROUNDED);
    return new Outcome(List.of(map), values);
  }

  private Image read(String name) throws ToolException {
    String shown = PrintableText.quoted(name);
    try {
      byte[] content = Roots.content(roots.file(name), limits);
      if (content.length > limits.bytes()) {
        throw new ToolException(shown + ": expected at most " + limits.bytes() + " bytes");
      }
      Image light = ImageFormat.read(content, limits.withTexels(MOST_PIXELS)).light();
      for (float value : light.rgb()) {
        if (!Float.isFinite(value)) {
          throw new ToolException(shown + ": expected finite values, found NaN or infinite ones");
        }
      }
      return light;
    } catch (ImageFormatException e) {
      throw new ToolException(shown + ": " + e.getMessage(), e);
    } catch (IOException e) {
      Interrupts.check();
      throw new ToolException(shown + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }
}
