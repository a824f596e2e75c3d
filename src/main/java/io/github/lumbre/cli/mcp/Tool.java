package io.github.lumbre.cli.mcp;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Something that a client can call. Thread-safe. */
interface Tool {
  /** What the tool is called. */
  String name();

  /** What a person calls the tool. */
  String title();

  /** What the tool does, for language models. */
  String description();

  /** The arguments it takes, in the order in which they are listed. */
  List<Input<?>> inputs();

  /** The members of the values that its calls return. */
  List<Output> outputs();

  /**
   * Does the work.
   *
   * @throws ToolException if the arguments or the model are at fault
   * @throws InterruptedException if the call is cancelled
   */
  Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException;

  /**
   * What a call results in.
   *
   * @param pictures PNG files, at most a few
   * @param values numbers and names, for programs
   * @param text the same for readers; empty for the values as JSON
   */
  record Outcome(List<byte[]> pictures, Map<String, Object> values, Optional<String> text) {
    public Outcome {
      pictures = List.copyOf(pictures);
    }

    /** Creates an outcome whose text are its values. */
    Outcome(List<byte[]> pictures, Map<String, Object> values) {
      this(pictures, values, Optional.empty());
    }
  }
}
