package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/** A model file with the files beside it, in memory. Mutable. */
public final class ModelFixture {
  private final String name;
  private final byte[] content;
  private final Map<String, byte[]> files = new HashMap<>();
  private ModelOptions options = ModelOptions.DEFAULT;

  public ModelFixture(String name, byte[] content) {
    this.name = name;
    this.content = content;
  }

  public ModelFixture(String name, String content) {
    this(name, content.getBytes(StandardCharsets.UTF_8));
  }

  public ModelFixture with(String file, byte[] bytes) {
    files.put(file, bytes);
    return this;
  }

  public ModelFixture with(String file, String text) {
    return with(file, text.getBytes(StandardCharsets.UTF_8));
  }

  public ModelFixture with(ModelOptions given) {
    options = given;
    return this;
  }

  private byte[] file(String file, String location) throws ModelFormatException {
    byte[] bytes = files.get(file);
    if (bytes == null) {
      throw new ModelFormatException(Kind.ASSET, location, "expected a file, found none: " + file);
    }
    return bytes;
  }

  public Model read() throws ModelFormatException {
    try {
      return ModelReader.read(name, content, this::file, options);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the only part. */
  public ModelPart part() throws ModelFormatException {
    Model model = read();
    if (model.parts().size() != 1) {
      throw new AssertionError(model.parts());
    }
    return model.parts().get(0);
  }

  public ModelGeometry geometry() throws ModelFormatException {
    return part().geometry();
  }

  /** Returns the kind and message of the exception. */
  public String refusal() {
    ModelFormatException thrown = catchThrowableOfType(ModelFormatException.class, this::read);
    return thrown == null ? "none" : thrown.kind() + " " + thrown.getMessage();
  }

  public static Vec3 mapped(ModelPart part, double x, double y, double z) {
    return part.toWorld().point(new Vec3(x, y, z));
  }
}
