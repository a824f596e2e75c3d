package io.github.lumbre.base.json;

/** Thrown if a text is not JSON, or exceeds a limit. */
public final class JsonException extends Exception {
  private static final long serialVersionUID = 1;

  private final String path;
  private final boolean isTooLarge;

  JsonException(String path, boolean isTooLarge, String message) {
    super(message);
    this.path = path;
    this.isTooLarge = isTooLarge;
  }

  /** Returns the place, such as {@code $.objects[3]}. */
  public String path() {
    return path;
  }

  /** Returns whether the text exceeds a limit. */
  public boolean isTooLarge() {
    return isTooLarge;
  }
}
