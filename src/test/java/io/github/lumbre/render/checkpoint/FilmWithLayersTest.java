package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scene.Setting;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests checkpoint files of films with layers. */
class FilmWithLayersTest {
  private static final Set<Layer> ALL = EnumSet.allOf(Layer.class);
  private static final Crop FRAME = new Crop(0, 0, 9, 6);

  @TempDir private Path folder;

  private static Scene scene() {
    SceneAssembly scene =
        new SceneAssembly(Lens.pinhole(60).camera(new Vec3(0, 0, -4), Frame.WORLD, 1.5))
            .lightGroup("sky")
            .add(EnvironmentLight.uniform(Rgb.WHITE));
    for (int i = 0; i < 200; i++) {
      Vec3 center = new Vec3(.17 * (i % 20) - 1.7, .3 * (i / 20) - 1.5, 0);
      scene.named("ball\n" + i % 11, "gray");
      scene.add(new Sphere(Transform.translation(center), .1), Matte.GRAY);
    }
    return scene.build();
  }

  private static RenderSettings settings(Set<Layer> layers, Crop crop) {
    return new RenderSettings.Builder()
        .size(FRAME.width(), FRAME.height())
        .crop(crop)
        .set(Setting.LAYERS, layers)
        .build();
  }

  private static FilmFile film(Set<Layer> layers, Crop crop, int first, int samples)
      throws InterruptedException {
    Scene scene = scene();
    RenderSettings settings = settings(layers, crop);
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm(first);
    renderer.addSamples(film, samples, Progress.NONE);
    return FilmFile.of(
        FilmHeader.identity("ab12", settings),
        film,
        RecordedLayers.of(settings, scene),
        Map.of(),
        RenderStatistics.ZERO);
  }

  private Path written(FilmFile film) throws IOException {
    Path path = folder.resolve("a.film");
    try (OutputFile output = OutputFile.open(path)) {
      film.write(output);
      output.commit();
    }
    return path;
  }

  @Test
  void layersAreReadAsTheyWereWritten() throws IOException, InterruptedException {
    FilmFile film = film(ALL, FRAME, 0, 70);
    Path path = written(film);
    assertThat(Files.readAllLines(path, StandardCharsets.ISO_8859_1).get(0))
        .isEqualTo("LUMBRE-FILM 2");
    FilmFile read = FilmFile.read(path);
    assertThat(read.header()).isEqualTo(film.header());
    assertThat(read.header().layers().lightGroups()).containsExactly("sky");
    assertThat(read.header().layers().objects().get(3)).isEqualTo("ball\n3");
    assertThat(FilmFixture.pixels(read.film())).isEqualTo(FilmFixture.pixels(film.film()));
  }

  @Test
  void filmsWithoutLayersKeepTheFirstVersion() throws IOException, InterruptedException {
    Path path = written(film(Set.of(), FRAME, 0, 2));
    assertThat(Files.readAllLines(path, StandardCharsets.ISO_8859_1).get(0))
        .isEqualTo("LUMBRE-FILM 1");
  }

  /** Pixels whose samples hit many primitives are longer than the reader's buffer. */
  @Test
  void pixelsLongerThanTheBufferAreRead() throws IOException {
    Film film =
        new Film(
            new Crop(0, 0, 2, 1),
            false,
            0,
            new RecordedLayers(Set.of(Layer.OBJECT), List.of(), List.of(), List.of()).ofFilm());
    int primitives = 30_000;
    ByteBuffer pixel = ByteBuffer.allocate(1 << 20);
    number(pixel, primitives);
    for (int i = 0; i < 3; i++) {
      number(pixel, 1);
      pixel.putLong(0);
    }
    pixel.putLong(1);
    number(pixel, primitives);
    for (int i = 0; i < primitives; i++) {
      number(pixel, i);
      number(pixel, 1);
    }
    film.decode(0, pixel.duplicate().flip());
    film.decode(1, pixel.duplicate().flip());
    assertThat(film.encodedBytes(0)).isGreaterThan(1 << 16);
    FilmFile file =
        FilmFile.of(
            Map.of(),
            film,
            new RecordedLayers(Set.of(Layer.OBJECT), List.of(), List.of(), List.of()),
            Map.of(),
            RenderStatistics.ZERO);
    Film read = FilmFile.read(written(file)).film();
    assertThat(FilmFixture.pixels(read)).isEqualTo(FilmFixture.pixels(film));
    assertThat(read.primitives(1)).hasSize(primitives);
  }

  private static void number(ByteBuffer out, int number) {
    int rest = number;
    while (rest > 0x7f) {
      out.put((byte) (rest | 0x80));
      rest >>>= 7;
    }
    out.put((byte) rest);
  }

  /**
   * The balls of a pixel share few names, and their first hits differ in the parts. Shares of 24
   * samples are rounded.
   */
  @Test
  void mergedFilmsHaveTheLayersOfASingleRender() throws Exception {
    FilmFile whole = film(ALL, FRAME, 0, 24);
    List<FilmMerge.Named> parts =
        List.of(
            new FilmMerge.Named("c", film(ALL, FRAME, 16, 8)),
            new FilmMerge.Named("a", film(ALL, new Crop(0, 0, 4, 6), 0, 16)),
            new FilmMerge.Named("b", film(ALL, new Crop(4, 0, 5, 6), 0, 16)));
    FilmFile merged = FilmMerge.of(parts);
    assertThat(FilmFixture.pixels(merged.film())).isEqualTo(FilmFixture.pixels(whole.film()));
    assertThat(merged.header().layers()).isEqualTo(whole.header().layers());
    assertSameLayers(merged, whole);
    assertSameLayers(FilmFile.read(written(whole)), whole);
  }

  private static void assertSameLayers(FilmFile actual, FilmFile expected) {
    FilmPicture picture = FilmPicture.of(actual.film(), actual.header().layers());
    FilmPicture same = FilmPicture.of(expected.film(), expected.header().layers());
    assertThat(picture.image().rgb()).isEqualTo(same.image().rgb());
    assertThat(picture.metadata()).isEqualTo(same.metadata());
    assertThat(picture.layers()).hasSameSizeAs(same.layers()).hasSizeGreaterThan(ALL.size());
    for (int i = 0; i < same.layers().size(); i++) {
      assertThat(picture.layers().get(i).values())
          .as(same.layers().get(i).name())
          .isEqualTo(same.layers().get(i).values());
    }
  }

  @Test
  void filmsWithOtherLayersAreNotMerged() throws InterruptedException {
    FilmMerge.Named a = new FilmMerge.Named("a", film(Set.of(), FRAME, 0, 1));
    FilmMerge.Named b = new FilmMerge.Named("b", film(Set.of(Layer.DEPTH), FRAME, 1, 1));
    assertThatThrownBy(() -> FilmMerge.of(List.of(a, b)))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage("layers: a has nothing, b has depth");
  }

  @Test
  void wrongHeadersAreRefusedForTheReason() throws IOException, InterruptedException {
    Path path = written(film(ALL, FRAME, 0, 2));
    String text = new String(FilmFixture.content(path), StandardCharsets.ISO_8859_1);
    FilmFixture.assertRefused(
        path, text.replace("layers: albedo", "layers: albino"), "did you mean albedo?");
    FilmFixture.assertRefused(path, text.replace("layers: albedo,", "layers: "), "pixel");
    FilmFixture.assertRefused(
        path,
        text.replaceFirst("\nmaterial: gray", ""),
        "materials: expected 200 names, found 199");
    String groups = "light-group: sky\n".repeat(257);
    FilmFixture.assertRefused(
        path, text.replace("light-group: sky\n", groups), "expected at most 256, found 257");
  }

  /** Any change of any byte gives a film or a message, never another exception. */
  @Test
  void damagedContentIsRefusedOrRead() throws IOException, InterruptedException {
    Path path = written(film(ALL, FRAME, 0, 5));
    byte[] content = FilmFixture.content(path);
    Random random = new Random(3);
    int read = 0;
    for (int run = 0; run < 3000; run++) {
      byte[] damaged = content.clone();
      for (int i = 0; i <= random.nextInt(3); i++) {
        damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
      }
      FilmFixture.writeSealed(path, damaged);
      try {
        FilmFile.read(path);
        read++;
      } catch (FilmFormatException e) {
        assertThat(e.getMessage()).isNotBlank();
      }
    }
    assertThat(read).isBetween(1, 2999);
  }
}
