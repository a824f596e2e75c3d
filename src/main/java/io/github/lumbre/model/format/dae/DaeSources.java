package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The vectors that sources hold, by their accessors. An accessor's count has no effect but a
 * warning: its array decides. Mutable: vectors are made once.
 */
final class DaeSources {
  static final int POSITION = 3;
  static final int NORMAL = 3;
  static final int UV = 2;
  static final int COLOR = 4;

  /** Larger components of colors are not 1, rounded. */
  private static final double MAX_FRACTION = 1.001;

  private static final double MAX_BYTE = 255;

  private final DaeDocument document;
  private final FormatFile file;
  private final Map<DaeElement, Map<Integer, double[]>> known;

  DaeSources(DaeDocument document) {
    this(document, new IdentityHashMap<>());
  }

  private DaeSources(DaeDocument document, Map<DaeElement, Map<Integer, double[]>> known) {
    this.document = document;
    file = document.file();
    this.known = known;
  }

  /** Returns the sources as references of a document lead to them. */
  DaeSources of(DaeDocument scoped) {
    return new DaeSources(scoped, known);
  }

  /**
   * Returns the positions or normals of a source, some of which may not be finite.
   *
   * @param reference to the source
   * @param location of the reference, for warnings
   */
  double[] vectors(String reference, String location) throws ModelFormatException {
    return values(reference, location, POSITION);
  }

  /** Returns the texture coordinates of a source; those that are not finite are 0. */
  double[] uvs(String reference, String location) throws ModelFormatException {
    return values(reference, location, UV);
  }

  /** Returns the colors of a source: three linear components and alpha. */
  double[] colors(String reference, String location) throws ModelFormatException {
    return values(reference, location, COLOR);
  }

  private double[] values(String reference, String location, int size)
      throws ModelFormatException {
    Optional<DaeElement> source = document.find("source", reference, location);
    if (source.isEmpty()) {
      return new double[0];
    }
    Map<Integer, double[]> ofSource = known.computeIfAbsent(source.get(), s -> new HashMap<>());
    double[] found = ofSource.get(size);
    if (found == null) {
      found = read(source.get(), size);
      if (size == UV) {
        found = finite(found, source.get());
      } else if (size == COLOR) {
        found = linear(found, source.get());
      }
      ofSource.put(size, found);
    }
    return found;
  }

  private double[] read(DaeElement source, int size) throws ModelFormatException {
    DaeElement accessor = source.find("technique_common", "accessor").orElse(source);
    Optional<DaeElement> array = source.find("float_array");
    if (array.isEmpty() && !accessor.attribute("source").isEmpty()) {
      array = document.find("float_array", accessor.attribute("source"), accessor.location());
    }
    double[] numbers = array.map(DaeElement::numbers).orElse(new double[0]);
    int params = accessor.children("param").size();
    int least = Math.max(1, params);
    int stride =
        accessor == source
            ? size
            : within(accessor, "stride", least, params == 0 ? size : params, numbers);
    int offset = within(accessor, "offset", 0, 0, numbers);
    array.ifPresent(
        all -> warnOfMissing(all, accessor, Math.max(0, numbers.length - offset) / stride));
    int[] components = components(accessor, size, stride);
    boolean isPlain =
        offset == 0
            && stride == size
            && Arrays.equals(components, IntStream.range(0, size).toArray());
    return isPlain && numbers.length % size == 0
        ? numbers
        : gathered(numbers, offset, stride, components, source.location());
  }

  /**
   * Returns a number that an accessor states, from a least one to the length of the array;
   * otherwise the least one, with a warning.
   *
   * @param missing the number if none is stated
   */
  private int within(
      DaeElement accessor, String name, int least, int missing, double... numbers) {
    String found = accessor.attribute(name).strip();
    int stated = found.isEmpty() ? missing : accessor.integer(name, -1);
    if (found.isEmpty() || stated == least || stated > least && stated <= numbers.length) {
      return stated;
    }
    file.warnings()
        .add(
            "wrong strides and offsets",
            accessor.location(),
            "%s: expected %d to %d, found %s; %d is used"
                .formatted(
                    name,
                    least,
                    Math.max(least, numbers.length),
                    PrintableText.quoted(found),
                    least));
    return least;
  }

  /**
   * Warns of counts that are larger than what there is.
   *
   * @param vectors number of them in the array
   */
  private void warnOfMissing(DaeElement array, DaeElement accessor, int vectors) {
    int numbers = array.numbers().length;
    if (array.integer("count", 0) > numbers) {
      warnOfMissing(array, "numbers", array.integer("count", 0), numbers);
    } else if (accessor.integer("count", 0) > vectors) {
      warnOfMissing(accessor, "vectors", accessor.integer("count", 0), vectors);
    }
  }

  private void warnOfMissing(DaeElement element, String what, int stated, int found) {
    file.warnings()
        .add(
            "fewer " + what + " than stated",
            element.location(),
            "expected %d %s, found %d".formatted(stated, what, found));
  }

  private double[] gathered(
      double[] numbers, int offset, int stride, int[] components, String location)
      throws ModelFormatException {
    int count = Math.max(0, numbers.length - offset) / stride;
    file.take(location, (long) Double.BYTES * components.length * count);
    double[] values = new double[Math.multiplyExact(components.length, count)];
    for (int i = 0; i < values.length; i++) {
      int component = components[i % components.length];
      boolean isAlpha = i % components.length == COLOR - 1;
      values[i] =
          component < 0
              ? isAlpha ? 1 : 0
              : numbers[offset + stride * (i / components.length) + component];
    }
    return values;
  }

  /**
   * Returns where the components of a vector are: the parameters that have names, or all numbers if
   * none has one; -1 for those that are missing.
   */
  private static int[] components(DaeElement accessor, int size, int stride) {
    List<DaeElement> params = accessor.children("param");
    int[] named =
        IntStream.range(0, params.size())
            .filter(i -> !params.get(i).attribute("name").isEmpty())
            .toArray();
    int[] all = named.length > 0 ? named : IntStream.range(0, Math.min(stride, size)).toArray();
    int[] components = Arrays.copyOf(all, size);
    Arrays.fill(components, Math.min(all.length, size), size, -1);
    return components;
  }

  private double[] finite(double[] uvs, DaeElement source) {
    double[] finite = uvs;
    for (int i = 0; i < uvs.length; i++) {
      if (!Double.isFinite(uvs[i])) {
        finite = finite == uvs ? uvs.clone() : finite;
        finite[i] = 0;
        file.tally().add("took texture coordinates that are not finite for 0", source.location());
      }
    }
    return finite;
  }

  /** Returns sRGB-encoded colors as linear ones; those that are not finite are white. */
  private double[] linear(double[] colors, DaeElement source) {
    double largest = Arrays.stream(colors).filter(Double::isFinite).max().orElse(0);
    if (largest > MAX_BYTE) {
      warn(source, "ignored the colors of vertices: expected 0 to 1 or 0 to 255, found ", largest);
      return new double[0];
    }
    boolean isBytes = largest > MAX_FRACTION;
    if (isBytes) {
      warn(source, "took the colors of vertices for 0 to 255: expected 0 to 1, found ", largest);
    }
    double[] linear = new double[colors.length];
    for (int i = 0; i < linear.length; i++) {
      boolean isFinite = Double.isFinite(colors[i]);
      if (!isFinite) {
        file.tally().add("took colors of vertices that are not finite for 1", source.location());
      }
      boolean isAlpha = i % COLOR == COLOR - 1;
      double stated = isFinite ? Math.max(0, colors[i] / (isBytes ? MAX_BYTE : 1)) : 1;
      // A missing alpha is 1 among bytes, too.
      double shown = isAlpha && isBytes && colors[i] == 1 ? 1 : Math.min(1, stated);
      linear[i] = isAlpha ? shown : Srgb.decode(shown);
    }
    return linear;
  }

  private void warn(DaeElement source, String message, double largest) {
    file.warnings().add(source.location(), message + PrintableText.number(largest));
  }
}
