package io.github.lumbre.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the suggestions for misspelled names. */
class SpellingTest {
  @ParameterizedTest
  @CsvSource({
    "width, width, 0",
    "Width, width, 0",
    "widht, width, 1",
    "wdth, width, 1",
    "widtth, width, 1",
    "wigth, width, 1",
    "raduis, radius, 1",
    "height, width, 4",
  })
  void distanceCountsEditsAndSwaps(String one, String other, int edits) {
    assertThat(Spelling.distance(one, other)).isEqualTo(edits);
    assertThat(Spelling.distance(other, one)).isEqualTo(edits);
  }

  @Test
  void nearestKnownWordIsSuggested() {
    List<String> known = List.of("width", "height", "radius");

    assertThat(Spelling.suggestion("widht", known)).isEqualTo("; did you mean width?");
    assertThat(Spelling.suggestion("colour", known)).isEmpty();
  }

  @Test
  void ofSeveralKnownWordsTheNearestIsSuggested() {
    assertThat(Spelling.suggestion("raduis", List.of("radii", "radios", "radius")))
        .isEqualTo("; did you mean radius?");
    assertThat(Spelling.suggestion("radix", List.of("radiz", "radim", "radis")))
        .isEqualTo("; did you mean radim?");
  }

  @Test
  void wholeOfAShortFormIsSuggested() {
    List<String> known =
        List.of(
            "fieldOfView", "localPosition", "localRotation", "lookAt", "roughness", "roughWood");
    assertThat(Spelling.suggestion("fov", known)).isEqualTo("; did you mean fieldOfView?");
    assertThat(Spelling.suggestion("position", known)).isEqualTo("; did you mean localPosition?");
    assertThat(Spelling.suggestion("Rotation", known)).isEqualTo("; did you mean localRotation?");
    assertThat(Spelling.suggestion("look", known)).isEqualTo("; did you mean lookAt?");
    // Of several, none.
    assertThat(Spelling.suggestion("rough", known)).isEmpty();
    assertThat(Spelling.suggestion("loc", known)).isEmpty();
  }

  @Test
  void wordsOfMoreThanFortyLettersGetNoSuggestion() {
    String forty = "x".repeat(40);
    assertThat(Spelling.suggestion(forty, List.of(forty))).contains(forty);
    String more = "x".repeat(41);
    assertThat(Spelling.suggestion(more, List.of(more))).isEmpty();
  }
}
