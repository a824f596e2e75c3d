package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.model.internal.PartSelection;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scenefile.internal.PartSurface;
import io.github.lumbre.scenefile.internal.PartTable.Part;
import io.github.lumbre.stage.internal.ViewNumbers;
import io.github.lumbre.stage.internal.ViewNumbers.Seen;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** Cuts a picture to the rectangle in which parts are seen. Stateless. */
final class PartCrop {
  /** The margin around the parts, relative to the longer side of their rectangle. */
  private static final double MARGIN = .05;

  private static final int LEAST_MARGIN = 2;

  private static final int MOST_NAMES = 20;

  private PartCrop() {}

  /**
   * Returns a shot of the part of its frame in which parts are seen.
   *
   * @param name of a part, as it is listed; {@code *} stands for any text
   * @throws ToolException if no such part is seen
   */
  static Shot of(Shot whole, String name) throws ToolException {
    if (!whole.isModel()) {
      throw new ToolException("crop: requires a model; a scene in JSON has no parts");
    }
    RenderSettings settings = whole.file().settings();
    List<Part> parts = whole.parts().parts();
    Set<String> named = named(name, whole);
    List<Seen> seen = ViewNumbers.of(whole.file().scene(), settings, whole.parts()).seen();
    List<Seen> meant =
        seen.stream().filter(s -> named.contains(parts.get(s.part()).name())).toList();
    if (meant.isEmpty()) {
      List<String> visible = seen.stream().map(s -> parts.get(s.part()).name()).toList();
      throw failure(name, !named.isEmpty(), visible);
    }
    return whole.with(settings.toBuilder().crop(around(meant, settings)).build());
  }

  /** Returns the names of the parts that match the name, or are inside a part that does. */
  private static Set<String> named(String name, Shot shot) {
    Predicate<String> isMeant = text -> PartSelection.isMeant(name, text);
    Set<String> names = new HashSet<>();
    shot.parts().parts().stream().map(Part::name).filter(isMeant).forEach(names::add);
    shot.file().parsed().model().orElseThrow().surfaces().values().stream()
        .map(PartSurface::node)
        .filter(node -> node.matches(isMeant))
        .forEach(node -> names.add(node.label()));
    return names;
  }

  private static ToolException failure(String name, boolean isHidden, List<String> visible) {
    List<String> shown = new ArrayList<>();
    visible.stream().limit(MOST_NAMES).map(PrintableText::quoted).forEach(shown::add);
    if (visible.size() > MOST_NAMES) {
      shown.add("one of %d others".formatted(visible.size() - MOST_NAMES));
    }
    String expected = shown.isEmpty() ? "a visible part, and none is" : String.join(", ", shown);
    return new ToolException(
        "crop: expected %s, found %s%s"
            .formatted(
                expected,
                PrintableText.quoted(name),
                isHidden
                    ? ", which is not seen in this view; change 'view' or hide what is before it"
                    : Spelling.suggestion(name, visible)));
  }

  private static Crop around(List<Seen> parts, RenderSettings settings) {
    int left = parts.stream().mapToInt(Seen::left).min().orElseThrow();
    int top = parts.stream().mapToInt(Seen::top).min().orElseThrow();
    int right = parts.stream().mapToInt(Seen::right).max().orElseThrow();
    int bottom = parts.stream().mapToInt(Seen::bottom).max().orElseThrow();
    int longer = Math.max(right - left, bottom - top);
    int margin = Math.max(LEAST_MARGIN, (int) Math.round(MARGIN * longer));
    int x = Math.max(0, left - margin);
    int y = Math.max(0, top - margin);
    return new Crop(
        x,
        y,
        Math.min(settings.width(), right + margin) - x,
        Math.min(settings.height(), bottom + margin) - y);
  }
}
