package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.XmlReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/** The elements of a COLLADA file, and those with ids by their names and ids. */
final class DaeDocument {
  /** The numbers of a matrix. */
  private static final int MOST_NUMBERS = 16;

  private static final Pattern SPACE = Pattern.compile("\\s+");

  /** Finds elements by their {@linkplain #key keys}. */
  interface Ids {
    Optional<DaeElement> find(String key);
  }

  private final DaeElement root;
  private final Ids byId;
  private final FormatFile file;

  /** Images by their names; empty before the first is wanted. */
  private Optional<Map<String, DaeElement>> images = Optional.empty();

  DaeDocument(DaeElement root, Ids byId, FormatFile file) {
    this.root = root;
    this.byId = byId;
    this.file = file;
  }

  /**
   * Returns this document with the ids of a mesh or a skin before all others: some programs use ids
   * in every mesh anew.
   */
  DaeDocument within(DaeElement scope) {
    Map<String, DaeElement> own = new HashMap<>();
    for (DaeElement child : scope.children()) {
      own.putIfAbsent(key(child.name(), child.attribute("id")), child);
      for (DaeElement array : child.children("float_array")) {
        own.putIfAbsent(key(array.name(), array.attribute("id")), array);
      }
    }
    Ids ids = key -> Optional.ofNullable(own.get(key)).or(() -> byId.find(key));
    return new DaeDocument(root, ids, file);
  }

  /** Returns the key of an element among those with ids. */
  static String key(String name, String id) {
    return name + "#" + id.strip();
  }

  DaeElement root() {
    return root;
  }

  FormatFile file() {
    return file;
  }

  /** Returns the elements of a name in all libraries of a name. */
  List<DaeElement> library(String library, String name) {
    List<DaeElement> all = new ArrayList<>();
    root.children(library).forEach(each -> all.addAll(each.children(name)));
    return all;
  }

  /** Returns the element of a name and an id; empty if there is none. */
  Optional<DaeElement> withId(String name, String id) {
    return byId.find(key(name, id));
  }

  /** Returns the first image of a name: some programs write names for ids. */
  Optional<DaeElement> imageOfName(String name) {
    if (images.isEmpty()) {
      Map<String, DaeElement> named = new HashMap<>();
      for (DaeElement image : library("library_images", "image")) {
        named.putIfAbsent(image.attribute("name"), image);
      }
      images = Optional.of(named);
    }
    return name.isEmpty() ? Optional.empty() : Optional.ofNullable(images.get().get(name));
  }

  /**
   * Returns the element that a reference leads to; empty, with a warning, if it leads to another
   * file or nowhere.
   *
   * @param name of the element
   * @param reference such as {@code #id}; some programs omit the sign
   * @param location of the reference, for warnings
   */
  Optional<DaeElement> find(String name, String reference, String location) {
    String stated = reference.strip();
    int sign = stated.indexOf('#');
    if (sign > 0) {
      file.warnings()
          .add(
              "references to other files",
              location,
              "a reference to another file is left out: " + PrintableText.quoted(stated));
      return Optional.empty();
    }
    String id = stated.substring(sign + 1);
    Optional<DaeElement> found = withId(name, id).or(() -> withId(name, DaeUri.decoded(id)));
    if (found.isEmpty()) {
      file.warnings()
          .add(
              "references that lead nowhere",
              location,
              "expected the id of a <%s>, found %s, which is left out"
                  .formatted(name, PrintableText.quoted(stated)));
    }
    return found;
  }

  /**
   * Returns the first numbers in the text of an element, at most 16; empty, with a warning, if
   * there are fewer than expected.
   */
  Optional<double[]> numbers(DaeElement element, int count) {
    double[] numbers = leading(element);
    if (numbers.length >= count) {
      return Optional.of(numbers);
    }
    file.warnings()
        .add(
            "numbers that are missing or wrong",
            element.location(),
            "expected %d finite numbers in <%s>, found %s; it is ignored"
                .formatted(
                    count, element.name(), PrintableText.quoted(element.text())));
    return Optional.empty();
  }

  /** Returns the numbers at the beginning of the text of an element. */
  private double[] leading(DaeElement element) {
    List<Double> numbers = new ArrayList<>();
    for (String word : SPACE.split(element.text(), MOST_NUMBERS + 1)) {
      double number = number(word, element);
      if (Double.isNaN(number)) {
        break;
      }
      numbers.add(number);
    }
    return numbers.stream().mapToDouble(number -> number).toArray();
  }

  private double number(String word, DaeElement element) {
    double number = XmlReader.parsed(word);
    if (word.indexOf(',') >= 0 && !Double.isNaN(number)) {
      file.warnings()
          .once(
              " comma", element.location(), "commas in numbers are taken for decimal points");
    }
    return number;
  }
}
