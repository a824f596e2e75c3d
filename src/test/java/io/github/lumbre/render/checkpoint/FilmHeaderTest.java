package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

/** Tests which settings belong to the identity of a film. */
class FilmHeaderTest {
  private static RenderSettings settings(UnaryOperator<RenderSettings.Builder> change) {
    return change.apply(new RenderSettings.Builder().size(12, 7)).build();
  }

  private static FilmHeader header(Map<String, String> identity) {
    return new FilmHeader(
        identity,
        true,
        FilmFixture.FRAME,
        RecordedLayers.NONE,
        List.of(new FilmPart(FilmFixture.FRAME, 0, 1, 1)),
        RenderStatistics.ZERO,
        Map.of());
  }

  /** Settings that change samples change the film's identity; other settings do not. */
  @Test
  void settingsThatSamplesDependOnAreTheIdentity() {
    Map<String, String> usual = FilmHeader.identity("ab", settings(s -> s));
    assertThat(FilmHeader.identity("cd", settings(s -> s))).isNotEqualTo(usual);
    List<UnaryOperator<RenderSettings.Builder>> changes =
        List.of(
            s -> s.maxTraceDepth(9),
            s -> s.split(2),
            s -> s.seed(4),
            s -> s.size(13, 7),
            s -> s.size(12, 8),
            s -> s.transparent(true),
            s -> s.mode(Mode.RAY));
    for (UnaryOperator<RenderSettings.Builder> change : changes) {
      assertThat(FilmHeader.identity("ab", settings(change))).isNotEqualTo(usual);
    }
    assertThat(FilmHeader.identity("ab", settings(s -> s.samples(3).threads(1).bucketSize(5))))
        .isEqualTo(usual);
  }

  @Test
  void depthIsThatOfTheMode() {
    Map<String, String> path = FilmHeader.identity("ab", settings(s -> s.maxTraceDepth(9)));
    assertThat(path).containsEntry(FilmHeader.MODE, "path").containsEntry(FilmHeader.DEPTH, "9");
    Map<String, String> ray =
        FilmHeader.identity("ab", settings(s -> s.mode(Mode.RAY).rayDepths(3, 4)));
    assertThat(ray).containsEntry(FilmHeader.MODE, "ray").containsEntry(FilmHeader.DEPTH, "3,4");
  }

  /** Films of versions without path splitting do not state it. */
  @Test
  void filmsThatDoNotStateASplitHaveOne() {
    Map<String, String> one = FilmHeader.identity("ab", settings(s -> s.split(1)));
    assertThat(one).doesNotContainKey(Setting.SPLIT.name());
    Map<String, String> stated = new LinkedHashMap<>(one);
    stated.put(Setting.SPLIT.name(), "1");
    assertThatCode(() -> header(one).requireSame(stated, "a", "b")).doesNotThrowAnyException();
    Map<String, String> two = FilmHeader.identity("ab", settings(s -> s.split(2)));
    assertThatThrownBy(() -> header(one).requireSame(two, "a", "b"))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage("split: a has 1, b has 2");
  }
}
