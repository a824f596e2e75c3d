package io.github.lumbre.fuzz;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * The words of scenes.
 *
 * @param keys the keys of all objects
 * @param texts all short string values
 */
record Vocabulary(List<String> keys, List<String> texts) {
  private static final int LONGEST = 20;

  static Vocabulary of(List<JsonObject> scenes) {
    Set<String> keys = new TreeSet<>();
    Set<String> texts = new TreeSet<>();
    scenes.forEach(scene -> collect(scene, keys, texts));
    return new Vocabulary(List.copyOf(keys), List.copyOf(texts));
  }

  private static void collect(JsonElement element, Set<String> keys, Set<String> texts) {
    if (element instanceof JsonObject object) {
      for (Map.Entry<String, JsonElement> member : object.entrySet()) {
        keys.add(member.getKey());
        collect(member.getValue(), keys, texts);
      }
    } else if (element instanceof JsonArray array) {
      array.forEach(value -> collect(value, keys, texts));
    } else if (element.isJsonPrimitive() && element.getAsJsonPrimitive().isString()) {
      String text = element.getAsString();
      if (text.length() <= LONGEST) {
        texts.add(text);
      }
    }
  }
}
