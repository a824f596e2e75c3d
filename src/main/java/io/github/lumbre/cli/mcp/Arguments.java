package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Spelling;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The arguments of a call, checked by the declarations of a tool. Immutable. */
final class Arguments {
  private final Map<Input<?>, Object> values = new LinkedHashMap<>();
  private final Set<String> given;

  /**
   * @param given by their names
   * @throws ToolException that names the first argument that is wrong, missing or unknown
   */
  Arguments(List<Input<?>> inputs, Map<String, JsonValue> given) throws ToolException {
    this.given = Set.copyOf(given.keySet());
    List<String> names = inputs.stream().map(Input::name).toList();
    for (String name : given.keySet()) {
      if (!names.contains(name)) {
        throw new ToolException(
            PrintableText.quoted(name)
                + ": expected one of the arguments "
                + String.join(", ", names)
                + Spelling.suggestion(name, names));
      }
    }
    for (Input<?> input : inputs) {
      values.put(input, value(input, Optional.ofNullable(given.get(input.name()))));
    }
  }

  private static Object value(Input<?> input, Optional<JsonValue> given) throws ToolException {
    if (given.isEmpty() && input.defaultValue().isPresent()) {
      return input.defaultValue().get();
    }
    if (given.isEmpty()) {
      throw new ToolException(input.expected() + ", found none");
    }
    Optional<?> value = input.reader().read(given.get());
    if (value.isEmpty()) {
      throw new ToolException(input.expected() + ", found " + given.get().found());
    }
    return value.get();
  }

  /** Returns whether the client has stated an argument. */
  boolean isGiven(Input<?> input) {
    return given.contains(input.name());
  }

  /** Returns the value of an argument that the client has stated; otherwise empty. */
  <T> Optional<T> given(Input<T> input) {
    return isGiven(input) ? Optional.of(get(input)) : Optional.empty();
  }

  /** Returns the value of an argument; of one that the tool does not take, the default. */
  @SuppressWarnings("unchecked") // The constructor puts values of this type.
  <T> T get(Input<T> input) {
    return values.containsKey(input) ? (T) values.get(input) : input.defaultValue().orElseThrow();
  }
}
