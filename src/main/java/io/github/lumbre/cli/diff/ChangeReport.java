package io.github.lumbre.cli.diff;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.difference.FileSpace;
import io.github.lumbre.model.difference.ModelDifference;
import io.github.lumbre.model.difference.PartChange;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What changed between two models, as texts and as values for JSON.
 *
 * @param near largest distance of vertices that count as the same, in world units
 */
public record ChangeReport(ModelDifference.Result found, double near) {
  private static final String FORMAT = "lumbre-diff-1";

  /** Returns the numbers of changes by their kinds. */
  public String summary() {
    Map<PartChange.Kind, Integer> counts = new EnumMap<>(PartChange.Kind.class);
    found.changes().forEach(change -> counts.merge(change.kind(), 1, Integer::sum));
    List<String> texts = new ArrayList<>();
    counts.forEach((kind, count) -> texts.add(count + " " + ChangePage.word(kind)));
    String unchanged = found.notCompared().isEmpty() ? "the same" : "without a change found";
    texts.add(found.same() + " " + unchanged);
    return String.join(", ", texts);
  }

  /** Returns a text for each change. */
  public List<String> lines() {
    return found.changes().stream().map(change -> text(change, found.space())).toList();
  }

  private static String text(PartChange change, FileSpace space) {
    List<String> texts = new ArrayList<>();
    if (change.kind() == PartChange.Kind.MOVED) {
      if (change.distance() > 0) {
        texts.add("by " + space.text(change.shift()));
      }
      if (change.degrees() > 0) {
        texts.add("turned by " + Quantities.text(change.degrees()) + " degrees");
      }
    }
    texts.addAll(change.details());
    if (change.old().isPresent()
        && change.now().isPresent()
        && !change.old().equals(change.now())) {
      texts.add("was " + PrintableText.quoted(change.old().get()));
    }
    return String.join(", ", texts);
  }

  /**
   * Returns the values by their keys.
   *
   * @param old name of the old model
   * @param now name of the new model
   */
  public Map<String, Object> values(String old, String now) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("old", old);
    values.put("new", now);
    values.put("unit", found.space().unit());
    values.put("tolerance", found.space().length(near));
    values.put(found.notCompared().isEmpty() ? "same" : "withoutChangeFound", found.same());
    values.put("notCompared", found.notCompared());
    values.put("changes", found.changes().stream().map(ChangeReport::values).toList());
    return values;
  }

  private static Map<String, Object> values(PartChange change) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("kind", ChangePage.word(change.kind()));
    values.put("of", change.of().name().toLowerCase(Locale.ROOT));
    change.old().ifPresent(name -> values.put("old", name));
    change.now().ifPresent(name -> values.put("new", name));
    if (change.kind() == PartChange.Kind.MOVED) {
      Vec3 shift = change.shift();
      values.put("shift", List.of(shift.x(), shift.y(), shift.z()));
      values.put("distance", change.distance());
      values.put("degrees", change.degrees());
    }
    values.put("details", change.details());
    values.put("parts", Math.max(change.oldParts().size(), change.nowParts().size()));
    return values;
  }
}
