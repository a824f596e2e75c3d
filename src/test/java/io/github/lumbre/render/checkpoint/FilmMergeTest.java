package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests that merged films are bit-identical to a film of all samples. */
class FilmMergeTest {
  private static FilmMerge.Named named(String name, Crop window, int first, int count) {
    return new FilmMerge.Named(name, FilmFixture.file(window, first, (x, y) -> count));
  }

  /** Cuts a film randomly by pixels and sample numbers, shuffles the pieces and merges them. */
  @Test
  void anyPartitionGivesTheSameBits() throws FilmMismatchException {
    int samples = 9;
    FilmFile whole = FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> samples);
    Random random = new Random(60);
    for (int run = 0; run < 50; run++) {
      List<FilmMerge.Named> pieces = new ArrayList<>();
      int cut = 1 + random.nextInt(FilmFixture.FRAME.width() - 1);
      int height = FilmFixture.FRAME.height();
      Crop left = new Crop(0, 0, cut, height);
      Crop right = new Crop(cut, 0, FilmFixture.FRAME.width() - cut, height);
      for (Crop window : List.of(left, right)) {
        for (int from = 0; from < samples; ) {
          int count = 1 + random.nextInt(samples - from);
          pieces.add(named("piece " + pieces.size(), window, from, count));
          from += count;
        }
      }
      Collections.shuffle(pieces, random);
      FilmFile sum = FilmMerge.of(pieces);
      assertThat(FilmFixture.sums(sum.film())).isEqualTo(FilmFixture.sums(whole.film()));
      assertThat(sum.header()).isEqualTo(whole.header());
    }
  }

  /** Parts that end at powers of two, in any order, keep the estimate of the noise. */
  @Test
  void halvesStayKnownBetweenPowersOfTwo() throws FilmMismatchException {
    FilmFile whole = FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> 12);
    List<FilmMerge.Named> parts = new ArrayList<>();
    for (int[] range : new int[][] {{8, 2}, {2, 2}, {10, 2}, {4, 4}, {0, 2}}) {
      parts.add(named("from " + range[0], FilmFixture.FRAME, range[0], range[1]));
    }
    Film sum = FilmMerge.of(parts).film();
    assertThat(sum.halves(3, 4)).isPresent().isEqualTo(whole.film().halves(3, 4));
  }

  @Test
  void gapsStayKnown() throws FilmMismatchException {
    Crop frame = FilmFixture.FRAME;
    FilmMerge.Named partial =
        new FilmMerge.Named("b", FilmFixture.file(frame, 4, (x, y) -> 2 + x % 2));
    FilmFile sum = FilmMerge.of(List.of(named("a", frame, 0, 4), partial, named("c", frame, 8, 1)));
    assertThat(sum.header().parts())
        .containsExactlyInAnyOrder(new FilmPart(frame, 0, 6, 7), new FilmPart(frame, 8, 1, 1));
    FilmMerge.Named joined = new FilmMerge.Named("sum", sum);
    assertThat(FilmMerge.of(List.of(joined, named("d", frame, 7, 1))).header().parts()).hasSize(2);
    assertThatThrownBy(() -> FilmMerge.of(List.of(joined, named("e", frame, 6, 1))))
        .isInstanceOf(FilmMismatchException.class);
  }

  /** Four samples of four poses have no halves with all of them. */
  @Test
  void sumsKeepTheirPoses() throws FilmMismatchException {
    RenderSettings moving =
        new RenderSettings.Builder()
            .size(FilmFixture.FRAME.width(), FilmFixture.FRAME.height())
            .set(Setting.SHUTTER, .1)
            .set(Setting.POSES, 4)
            .build();
    List<FilmMerge.Named> films = new ArrayList<>();
    for (int first : new int[] {0, 4}) {
      Film film = new Film(FilmFixture.FRAME, true, first, FilmLayers.NONE, 4);
      film.addAll(FilmFixture.file(FilmFixture.FRAME, first, (x, y) -> 4).film());
      FilmFile file =
          FilmFile.of(
              FilmHeader.identity("ab12", moving),
              film,
              RecordedLayers.NONE,
              FilmFixture.NOTES,
              RenderStatistics.ZERO);
      films.add(new FilmMerge.Named("from " + first, file));
    }
    assertThat(FilmMerge.of(films.subList(0, 1)).film().halves(3, 4)).isEmpty();
    assertThat(FilmMerge.of(films).film().halves(3, 4)).isPresent();
    assertThat(FilmMerge.of(films).film().poses()).isEqualTo(4);
  }

  @Test
  void samplesInBothAreRefused() {
    FilmMerge.Named a = named("a", FilmFixture.FRAME, 0, 5);
    FilmMerge.Named b = named("b", new Crop(11, 6, 1, 1), 4, 2);
    assertThatThrownBy(() -> FilmMerge.of(List.of(a, b)))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage(
            "samples in common: a has samples 0 to 4 of 12x7 pixels at 0,0, and b has samples 4 to"
                + " 5 of 1x1 pixels at 11,6");
  }

  @Test
  void filmsOfOtherPicturesAreRefusedNamingWhatDiffers() {
    FilmMerge.Named a = named("a", FilmFixture.FRAME, 0, 1);
    FilmFile file = named("b", FilmFixture.FRAME, 1, 1).file();
    RenderSettings other =
        new RenderSettings.Builder().size(12, 7).seed(5).maxTraceDepth(9).build();
    FilmMerge.Named b =
        new FilmMerge.Named(
            "b",
            FilmFile.of(
                FilmHeader.identity("cd34", other),
                file.film(),
                RecordedLayers.NONE,
                FilmFixture.NOTES,
                file.header().faults()));
    assertThatThrownBy(() -> FilmMerge.of(List.of(a, b)))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage(
            "scene-hash: a has ab12, b has cd34; depth: a has 5, b has 9; seed: a has 0, b has 5");
  }
}
