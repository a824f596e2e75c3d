package io.github.lumbre.model.format.ies;

import static io.github.lumbre.model.format.ies.IesSamples.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of photometric files of lamps. */
class IesReaderTest {
  private static final List<Double> POLAR = steps(0, 180, 5);

  private final Warnings warnings = new Warnings();

  private static List<Double> steps(double from, double to, double step) {
    return DoubleStream.iterate(from, x -> x <= to, x -> x + step).boxed().toList();
  }

  private LightProfile read(String text) {
    try {
      return IesReader.read(IesSamples.bytes(text), warnings);
    } catch (ModelFormatException e) {
      throw new AssertionError(e);
    }
  }

  private ModelFormatException refusal(String text) {
    return catchThrowableOfType(
        ModelFormatException.class, () -> IesReader.read(IesSamples.bytes(text), warnings));
  }

  /** Returns the direction of two angles in degrees. */
  @Test
  void factorsAndTableAreRead() {
    LightProfile lamp = read(IesSamples.FULL);
    // Multiplier 2, ballast factor 0.9; the third number has no meaning since 1995.
    assertThat(lamp.intensity(direction(0, 0))).isCloseTo(180, within(1e-12));
    assertThat(lamp.intensity(direction(45, 0))).isCloseTo(1.8 * 80, within(1e-11));
    assertThat(lamp.intensity(direction(45, 90))).isCloseTo(1.8 * 60, within(1e-11));
    assertThat(lamp.intensity(direction(45, 135))).isCloseTo(1.8 * 70, within(1e-11));
    assertThat(lamp.intensity(direction(22.5, 180))).isCloseTo(1.8 * 90, within(1e-11));
    assertThat(lamp.intensity(direction(91, 0))).isZero();
    assertThat(warnings.all())
        .containsExactly(
            "line 5: the tilts are ignored, so that a tilted lamp is as bright as an upright one,"
                + " found TILT=\"INCLUDE\"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"TILT = NONE", "TILT =NONE", "tilt\t=\tNone ", "TILT= NONE\r"})
  void blanksAroundTheTiltHaveNoMeaning(String line) {
    LightProfile lamp = read(IesSamples.OLD.replace("TILT=NONE", line));
    assertThat(lamp.intensity(direction(0, 7))).isCloseTo(25, within(1e-12));
    assertThat(warnings.all()).isEmpty();
    assertThat(read(IesSamples.FULL.replace("TILT=INCLUDE", "TILT = INCLUDE")).largest())
        .isEqualTo(180);
  }

  @Test
  void oldFilesHaveAFactorOfTheBallastWithItsLamp() {
    LightProfile lamp = read(IesSamples.OLD);
    assertThat(lamp.intensity(direction(0, 7))).isCloseTo(25, within(1e-12));
    assertThat(lamp.intensity(direction(135, 7))).isCloseTo(17.5, within(1e-12));
    assertThat(read("IESNA91\n" + IesSamples.OLD).largest()).isEqualTo(25);
    assertThat(read("IESNA:LM-63-1995\n" + IesSamples.OLD).largest()).isEqualTo(50);
    assertThat(warnings.all()).isEmpty();
  }

  @Test
  void lineEndsDoNotMatter() {
    for (String end : new String[] {"\r\n", "\r"}) {
      String text = IesSamples.FULL.replace("\n", end);
      assertThat(read(text).flux()).isEqualTo(read(IesSamples.FULL).flux());
    }
    assertThat(read(IesSamples.FULL + "\u001a").largest()).isEqualTo(180);
    assertThat(warnings.all()).hasSize(1);
  }

  private void assertSame(LightProfile some, LightProfile all) {
    for (double polar = 0; polar <= 180; polar += 3.7) {
      for (double azimuth = -180; azimuth <= 360; azimuth += 11.3) {
        Vec3 direction = direction(polar, azimuth);
        assertThat(some.intensity(direction))
            .isCloseTo(all.intensity(direction), within(1e-9 * all.largest()));
      }
    }
    assertThat(some.flux()).isCloseTo(all.flux(), within(1e-12 * all.flux()));
  }

  /** Each function has the symmetry of the range of its horizontal angles. */
  @Test
  void symmetricFilesAreTheFullOnes() {
    DoubleBinaryOperator axial = (p, a) -> 1000 + p * (200 - p);
    DoubleBinaryOperator quadrants =
        (p, a) -> 1000 + p * StrictMath.pow(StrictMath.cos(Math.toRadians(a)), 2);
    DoubleBinaryOperator about0 = (p, a) -> 1000 + p * StrictMath.cos(Math.toRadians(a));
    DoubleBinaryOperator about90 = (p, a) -> 1000 + p * StrictMath.sin(Math.toRadians(a));
    List<Double> turn = steps(0, 360, 22.5);
    assertSame(lamp(List.of(0.), axial), lamp(turn, axial));
    assertSame(lamp(steps(0, 90, 22.5), quadrants), lamp(turn, quadrants));
    assertSame(lamp(steps(0, 180, 22.5), about0), lamp(turn, about0));
    assertSame(lamp(steps(90, 270, 22.5), about90), lamp(turn, about90));
    DoubleBinaryOperator skew = (p, a) -> 1000 + p * StrictMath.sin(Math.toRadians(a + 20));
    assertSame(lamp(steps(0, 350, 10), skew), lamp(steps(0, 360, 10), skew));
    assertThat(lamp(turn, skew).intensity(direction(90, 70)))
        .isGreaterThan(lamp(turn, skew).intensity(direction(90, 110)) + 10);
    assertThat(warnings.all()).isEmpty();
  }

  private LightProfile lamp(List<Double> horizontal, DoubleBinaryOperator candela) {
    return read(IesSamples.file(POLAR, horizontal, candela));
  }

  @Test
  void fluxOfACosineAndOfAnEvenLamp() {
    List<Double> fine = steps(0, 90, .25);
    DoubleBinaryOperator cosine = (p, a) -> 100 * StrictMath.cos(Math.toRadians(p));
    // The chord of a cosine over h = 0.25 degrees lies at most h²/12 below it, on average.
    double error = 100 * Math.PI * StrictMath.pow(Math.toRadians(.25), 2);
    assertThat(read(IesSamples.file(fine, List.of(0.), cosine)).flux())
        .isCloseTo(100 * Math.PI, within(error));
    assertThat(lamp(List.of(0.), (p, a) -> 5).flux()).isCloseTo(20 * Math.PI, within(1e-9));
  }

  @Test
  void moreLightThanTheLampsHaveIsAWarning() {
    read(IesSamples.OLD.replace("1000", "100"));
    assertThat(warnings.all())
        .containsExactly("the lamps are rated at 25 lm, but the candelas add up to 251 lm");
  }

  @Test
  void numbersThatAreLeftAreAWarning() {
    read(IesSamples.OLD + "7 8\n");
    assertThat(warnings.all())
        .containsExactly(
            "line 11: expected the end of the file after the last candela, found \"7\"");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "TILT=NONE | x | line 11: expected a line TILT=NONE of an IES file (LM-63), found its end",
        "1, 1000, 1, 3 | 1, 1000, 1, 0"
            + " | line 3: expected a whole number of vertical angles from 1, found \"0\"",
        "1, 1000, 1, 3 | 1, 1000, 1, 2.5"
            + " | line 3: expected a whole number of vertical angles from 1, found \"2.5\"",
        "1, 1000, 1, 3 | 1, 1000, 1, 1025"
            + " | line 3: expected at most 1024 vertical angles, found 1025",
        "1, 1000, 1, 3 | 1, 1000, 1, 1e20"
            + " | line 3: expected at most 1024 vertical angles, found 9223372036854775807",
        "1, 1000, 1, 3 | 1, 1000, 1, 600"
            + " | line 4: expected 1201 angles and candelas,"
            + " found the end of the file after at most 28",
        "1, 1, 1, 0 | 1, 2, 1, 0 | line 4: expected type C photometry (1), found type B;"
            + " ask for a file of type C, or convert it with a photometric editor",
        "1, 1, 1, 0 | 1, 3, 1, 0 | line 4: expected type C photometry (1), found type A;"
            + " ask for a file of type C, or convert it with a photometric editor",
        "1, 1, 1, 0 | 1, 4, 1, 0"
            + " | line 4: expected the photometric type 1, 2 or 3, found \"4\"",
        "0, 90, | 0, 200, | line 6: expected a vertical angle from 0 to 180 degrees, found \"200\"",
        "0, 90, | 90, 90, | line 6: expected a vertical angle above 90, found \"90\"",
        "100, 80 | 100, -80 | line 9: expected candelas of at least 0, found \"-80\"",
        "100, 80 | 100, x | line 9: expected a finite number, found \"x\"",
        "100, 80 | 100, 1e140 | line 9: expected fewer candelas, with all factors, found \"1e140\"",
        "180' '0 | 180' '45 | line 8: expected horizontal angles from 0 to 0, 90, 180 or 360,"
            + " or from 90 to 270, found \"45\"",
        "60' ' | ' ' | line 10: expected candelas, found the end of the file"
      })
  void errorsNameTheLine(String from, String to, String message) {
    String old = from.replace("' '", "\n");
    assertThat(IesSamples.OLD).contains(old);
    ModelFormatException e = refusal(IesSamples.OLD.replace(old, to.replace("' '", "\n")));
    assertThat(e).hasMessage(message);
    assertThat(e.kind())
        .isEqualTo(
            message.contains("at most 1024")
                ? Kind.TOO_LARGE
                : message.contains("type C") ? Kind.UNSUPPORTED : Kind.MALFORMED);
  }

  @Test
  void manyAnglesAreRead() {
    List<Double> many = new ArrayList<>(Collections.nCopies(1024, 0.));
    for (int i = 0; i < many.size(); i++) {
      many.set(i, 180. * i / (many.size() - 1));
    }
    assertThat(read(IesSamples.file(many, many, (p, a) -> 1)).flux())
        .isCloseTo(4 * Math.PI, within(1e-9));
  }
}
