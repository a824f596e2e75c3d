package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;

/** The rules by which DWA compression chooses the schemes of channels; mutable. */
final class ExrDwaRules {
  /** How a channel is compressed, in the order of the codes. */
  enum Scheme {
    /** Deflated. */
    DEFLATED,
    /** Quantized coefficients of cosines. */
    COSINES,
    /** Run-length encoded, then deflated. */
    RUNS
  }

  /**
   * What a rule says of its channels.
   *
   * @param color the place in a color that is stored as luminance and chroma: 0 to 2 for red, green
   *     and blue, or -1
   */
  record Choice(Scheme scheme, int color) {}

  private static final Choice DEFLATED = new Choice(Scheme.DEFLATED, -1);
  private static final int MAX_NAME = 128;

  /** What rules apply to: the last part of a channel's name, or its lower case, and its type. */
  private record Subject(String name, ExrChannel.Type type, boolean ignoresCase) {}

  private final Map<Subject, Choice> choices = new HashMap<>();

  /** Returns the rules of the first two versions, whose files have none. */
  static ExrDwaRules old() {
    ExrDwaRules rules = new ExrDwaRules();
    List<List<String>> colors =
        List.of(List.of("r", "red"), List.of("g", "grn", "green"), List.of("b", "blu", "blue"));
    for (ExrChannel.Type type : List.of(ExrChannel.Type.HALF, ExrChannel.Type.FLOAT)) {
      for (int i = 0; i < colors.size(); i++) {
        Choice choice = new Choice(Scheme.COSINES, i);
        colors.get(i).forEach(name -> rules.choices.put(new Subject(name, type, true), choice));
      }
      for (String name : List.of("y", "by", "ry")) {
        rules.choices.put(new Subject(name, type, true), new Choice(Scheme.COSINES, -1));
      }
    }
    for (ExrChannel.Type type : ExrChannel.Type.values()) {
      rules.choices.put(new Subject("a", type, true), new Choice(Scheme.RUNS, -1));
    }
    return rules;
  }

  /** Reads the rules of a block: for each, a name, packed numbers, and a type. */
  static ExrDwaRules read(ByteBuffer in) throws ImageFormatException {
    ExrDwaRules rules = new ExrDwaRules();
    int size = in.getShort() & 0xffff;
    int end = Objects.checkIndex(in.position() + size - Short.BYTES, in.limit() + 1);
    while (in.position() < end) {
      String name = ExrHeader.text(in);
      int packed = in.get() & 0xff;
      int type = in.get();
      int color = (packed >> 4) - 1;
      int scheme = packed >> 2 & 3;
      if (name.length() > MAX_NAME || color > 2 || scheme >= Scheme.values().length) {
        throw malformed("OpenEXR is damaged: a rule of DWA compression is unknown");
      }
      boolean ignoresCase = (packed & 1) != 0;
      rules.choices.put(
          new Subject(
              ignoresCase ? name.toLowerCase(Locale.ROOT) : name,
              ExrChannel.Type.values()[type],
              ignoresCase),
          new Choice(Scheme.values()[scheme], color));
    }
    return rules;
  }

  /** Returns what the rules say of a channel. */
  Choice choice(ExrChannel channel) {
    String name = channel.component();
    Choice exact = choices.get(new Subject(name, channel.type(), false));
    return exact != null
        ? exact
        : choices.getOrDefault(
            new Subject(name.toLowerCase(Locale.ROOT), channel.type(), true), DEFLATED);
  }
}
