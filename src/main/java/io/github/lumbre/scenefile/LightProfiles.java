package io.github.lumbre.scenefile;

import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.ies.IesReader;
import io.github.lumbre.model.internal.Warnings;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Reads the profiles of lamps that lights name, each once. Mutable. */
final class LightProfiles {
  private final AssetData data;
  private final Map<String, Optional<LightProfile>> known = new HashMap<>();

  LightProfiles(AssetData data) {
    this.data = data;
  }

  /** Returns the profile that a light names; empty, with an error added, if it cannot be used. */
  Optional<LightProfile> of(JsonNode light) {
    Optional<String> name = LightKinds.PROFILE.stated(light);
    if (name.isPresent() && !known.containsKey(name.get())) {
      known.put(name.get(), read(light, name.get()));
    }
    return name.flatMap(known::get);
  }

  private Optional<LightProfile> read(JsonNode light, String name) {
    Optional<AssetData.Content> content =
        data.file(light.problemPlace(LightKinds.PROFILE.name()), name);
    if (content.isEmpty()) {
      return Optional.empty();
    }
    ModelPlace place = new ModelPlace.OfObject(light, LightKinds.PROFILE.name(), name);
    try {
      Warnings warnings = new Warnings();
      LightProfile profile = IesReader.read(content.get().bytes(), warnings);
      warnings.all().forEach(place::warn);
      return Optional.of(profile);
    } catch (ModelFormatException e) {
      place.error(e);
      return Optional.empty();
    }
  }
}
