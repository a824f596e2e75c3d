package io.github.lumbre.model.internal;

import java.util.Objects;

/**
 * An encoded picture that textures of a model use. Compared by identity: textures that use one
 * picture share one object.
 */
public final class ModelImage {
  private final String location;
  private final byte[] encoded;

  /**
   * @param location of the picture in the model, such as {@code images[2]}, for messages
   * @param encoded the bytes of a picture file, not copied
   */
  public ModelImage(String location, byte[] encoded) {
    this.location = Objects.requireNonNull(location, "location");
    this.encoded = Objects.requireNonNull(encoded, "encoded");
  }

  /** Returns the picture's place in the model, for messages. */
  public String location() {
    return location;
  }

  /** Returns the bytes of the picture file, which must not be changed. */
  public byte[] encoded() {
    return encoded;
  }
}
