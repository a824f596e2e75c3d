package io.github.lumbre.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage.Sky;
import io.github.lumbre.stage.Stage.View;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Models show their shape if nothing is asked for: their sides differ in brightness. */
class DefaultLookTest {
  private static final int WIDTH = 32;
  private static final int HEIGHT = 24;

  @TempDir private Path directory;

  private Path write(String name, String text) throws Exception {
    return Files.writeString(directory.resolve(name), text, StandardCharsets.US_ASCII);
  }

  /** Returns a box of 6 by 4 by 2 around the origin. */
  private static String box() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 8; i++) {
      text.append("v ").append((i & 1) == 0 ? -3 : 3);
      text.append(' ').append((i & 2) == 0 ? -2 : 2);
      text.append(' ').append((i & 4) == 0 ? -1 : 1).append('\n');
    }
    return text
        + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  }

  private static Image picture(Path model, Stage stage) throws Exception {
    SceneParser parser =
        new SceneParser()
            .overriding(
                settings -> settings.toBuilder().size(WIDTH, HEIGHT).samples(16).build());
    SceneFile file = StagedModel.read(model, stage, parser).scene();
    return new PictureRenderer(file.settings()).render(file.scene());
  }

  /** Returns the mean light in the middle of a picture, which shows one side of the box. */
  private static double middle(Image image) {
    double sum = 0;
    for (int i = 0; i < 64; i++) {
      sum += image.pixel(WIDTH / 2 - 4 + i % 8, HEIGHT / 2 - 4 + i / 8).g() / 64;
    }
    return sum;
  }

  private static double side(Path model, String view) throws Exception {
    return middle(picture(model, Stage.DEFAULT.seenFrom(View.of(view))));
  }

  @Test
  void sidesOfABoxWithoutColorsDiffer() throws Exception {
    Path box = write("box.obj", box());
    double top = side(box, "top");
    double front = side(box, "front");
    double right = side(box, "right");
    assertThat(top / front).isBetween(1.35, 1.8);
    assertThat(front / right).isBetween(1.4, 3.);
    assertThat(side(box, "left")).isBetween(right, top * .8);
    assertThat(side(box, "back")).isBetween(right * .8, top * .8);
    assertThat(side(box, "bottom")).isBetween(right * .3, right);
    assertThat(top).as("is not burnt out").isBetween(.7, .95);
  }

  /** A black plastic reflects more of this light than of the soft studio. */
  @Test
  void blackPlasticsShine() throws Exception {
    write("black.mtl", "newmtl black\nKd .005 .005 .005\nKs .04 .04 .04\nNs 60\nillum 2\n");
    Path box = write("black.obj", "mtllib black.mtl\nusemtl black\n" + box());
    double soft = middle(picture(box, Stage.DEFAULT.under(Sky.STUDIO)));
    assertThat(middle(picture(box, Stage.DEFAULT)) / soft).isGreaterThan(1.1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"clay", "clay,lines"})
  void looksKeepTheirLight(String look) {
    assertThat(Stage.DEFAULT.with(Stage.LOOK, look).sky()).isEqualTo(Sky.STUDIO);
  }

  @Test
  void groundsAndBackgroundsKeepTheirLight() {
    assertThat(Stage.DEFAULT.sky()).isEqualTo(Sky.RELIEF);
    assertThat(Stage.DEFAULT.with(Stage.GROUND, true).sky()).isEqualTo(Sky.STUDIO);
    for (String background : List.of("white", "transparent", "sky")) {
      Stage stage = Stage.DEFAULT.with(Stage.BACKGROUND, background);
      assertThat(stage.sky()).as(background).isEqualTo(Sky.STUDIO);
      assertThat(stage.with(Stage.SKY, "relief").sky()).as(background).isEqualTo(Sky.RELIEF);
    }
  }

  /** What is behind the model is the same under both lights. */
  @Test
  void bothStudiosHaveOneGroundBehind() throws Exception {
    Path box = write("box.obj", box());
    Rgb relief = picture(box, Stage.DEFAULT).pixel(0, 0);
    Rgb soft = picture(box, Stage.DEFAULT.under(Sky.STUDIO)).pixel(0, 0);
    assertThat(relief.g()).isCloseTo(soft.g(), within(1e-6));
  }

  /** The ground before the foot of the box is darker than at the edge of the frame. */
  @Test
  void modelsHaveAContactShadowFromAbove() throws Exception {
    Image picture = picture(write("box.obj", box()), Stage.DEFAULT.seenFrom(View.of("0,20")));
    int row = HEIGHT - 1;
    while (picture.pixel(WIDTH / 2, row).g() < .45) {
      row--;
    }
    double ground = picture.pixel(WIDTH / 2, row + 2).g() / picture.pixel(0, row + 2).g();
    assertThat(ground).isBetween(.6, .93);
  }

  @ParameterizedTest
  @ValueSource(strings = {"0,0", "0,-20", "top"})
  void otherViewsHaveNone(String view) throws Exception {
    Image picture = picture(write("box.obj", box()), Stage.DEFAULT.seenFrom(View.of(view)));
    for (int row : List.of(0, HEIGHT - 1)) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(picture.pixel(x, row)).isEqualTo(picture.pixel(0, row));
      }
    }
  }

  @Test
  void groundsAndBackgroundsHaveNoContactShadow() throws Exception {
    Path box = write("box.obj", box());
    SceneParser parser =
        new SceneParser()
            .overriding(settings -> settings.toBuilder().size(WIDTH, HEIGHT).samples(4).build());
    SceneFile shown = StagedModel.read(box, Stage.DEFAULT, parser).scene();
    assertThat(shown.scene().backplate().orElseThrow().shadowOf()).isPresent();
    SceneFile onGround =
        StagedModel.read(box, Stage.DEFAULT.with(Stage.GROUND, true), parser).scene();
    assertThat(onGround.scene().backplate().orElseThrow().shadowOf()).isEmpty();
    for (String background : List.of("white", "sky", "transparent")) {
      Stage stage = Stage.DEFAULT.with(Stage.BACKGROUND, background);
      SceneFile file = StagedModel.read(box, stage, parser).scene();
      assertThat(file.scene().backplate()).as(background).isEmpty();
      assertThat(file.scene().primitives()).hasSameSizeAs(shown.scene().primitives());
    }
  }
}
