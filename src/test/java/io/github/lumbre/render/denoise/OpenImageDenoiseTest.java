package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.LinearReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests how the installed denoiser is called, with stand-ins for the program. */
@DisabledOnOs(OS.WINDOWS)
class OpenImageDenoiseTest {
  /** Copies the picture or the guide to the output, and reports a version. */
  private static final String COPY =
      """
      echo "device=CPU, version=2.5.1, msec=1"
      echo "$@" >> "$(dirname "$0")/calls.txt"
      case "$1" in --hdr|--alb|--nrm) from="$2";; esac
      while [ $# -gt 0 ]; do if [ "$1" = "-o" ]; then cp "$from" "$2"; fi; shift; done
      """;

  @TempDir private Path folder;

  private Path program(String script) throws IOException {
    Path file = Files.writeString(folder.resolve("oidnDenoise"), "#!/bin/sh\n" + script);
    return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private OpenImageDenoise denoiser(String script) throws IOException, DenoiseException {
    return OpenImageDenoise.find(Optional.of(program(script)), Map.of());
  }

  private static NoisyPicture picture() {
    float[] light = new float[3 * 4 * 2];
    Arrays.fill(light, .25f);
    NoisyPicture.Halves halves = new NoisyPicture.Halves(light, new float[0]);
    return new NoisyPicture(
        4, 2, halves, Optional.of(halves), Optional.of(halves), new float[0], 0);
  }

  private void assertFails(OpenImageDenoise denoiser, String... parts) {
    assertThatThrownBy(() -> denoiser.denoise(picture()))
        .isInstanceOf(DenoiseException.class)
        .hasMessageContaining("oidnDenoise")
        .satisfies(e -> assertThat(e.getMessage()).contains(parts));
  }

  @Test
  void guidesAreCleanedFirst() throws Exception {
    Denoised denoised = denoiser(COPY).withThreads(2).denoise(picture());
    assertThat(denoised.image().rgb()).containsOnly(.25f);
    assertThat(denoised.engine()).isEqualTo("Open Image Denoise 2.5.1");
    assertThat(denoised.change()).isZero();
    assertThat(denoised.relativeError()).isEmpty();
    String calls = Files.readString(folder.resolve("calls.txt"));
    assertThat(calls.lines().map(line -> line.split(" ")[0]))
        .containsExactly("--alb", "--nrm", "--hdr");
    assertThat(calls.lines()).allMatch(line -> line.endsWith("--threads 2"));
    assertThat(calls.lines().toList().get(2)).contains("--alb", "--nrm", "--clean_aux");
  }

  @Test
  void aHangingProgramIsEnded() throws Exception {
    long start = System.nanoTime();
    assertFails(denoiser("sleep 60\n").within(Duration.ofMillis(300)), "took longer", "0.3 s");
    assertThat(System.nanoTime() - start).isLessThan(20_000_000_000L);
  }

  @Test
  void aTalkingProgramIsEnded() throws Exception {
    assertFails(denoiser("yes\n").within(Duration.ofMillis(300)), "took longer");
  }

  @Test
  void failuresNameTheProgramAndItsLastWords() throws Exception {
    assertFails(denoiser("echo 'Error: no device'; exit 3\n"), "code 3", "Error: no device");
    assertFails(denoiser("kill -SEGV $$\n"), "failed with code");
    assertFails(denoiser("exit 0\n"), "no readable picture");
  }

  @Test
  void nonsenseIsRefused() throws Exception {
    String out = "while [ \"$1\" != -o ]; do shift; done\n";
    assertFails(denoiser(out + "echo hello > \"$2\"\n"), "no readable picture");
    String special = "a link or another special file";
    assertFails(denoiser(out + "ln -s \"$0\" \"$2\"\n"), "no readable picture", special);
    assertFails(denoiser(out + "mkfifo \"$2\"\n"), "no readable picture", special);
    assertFails(
        denoiser(out + "head -c 5000 /dev/zero > \"$2\"\n"),
        "no readable picture",
        "a file of 5000 bytes, expected at most 1120");
    assertFails(
        denoiser(out + "printf 'PF\\n1 1\\n-1.0\\n000011112222' > \"$2\"\n"),
        "expected a picture of 4x2, found 1x1");
    assertFails(
        denoiser(
            out
                + "{ printf 'PF\\n"
                + "4 2\\n"
                + "-1.0\\n"
                + "'; for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24; do"
                + " printf '\\000\\000\\300\\177'; done; } > \"$2\"\n"),
        "finite");
  }

  @Test
  void theProgramIsFoundByFlagVariableOrPath() throws Exception {
    Path program = program(COPY);
    for (Map<String, String> environment :
        List.of(
            Map.of("LUMBRE_OIDN", program.toString()),
            Map.of("LUMBRE_OIDN", folder.toString()),
            Map.of("PATH", "/nowhere:" + folder))) {
      assertThat(OpenImageDenoise.find(Optional.empty(), environment).program()).isEqualTo(program);
    }
    assertThatThrownBy(() -> OpenImageDenoise.find(Optional.empty(), Map.of("PATH", "/nowhere")))
        .isInstanceOf(DenoiseException.class)
        .hasMessageContaining("not found on the PATH")
        .hasMessageContaining("pip install pyoidn");
    assertThatThrownBy(() -> OpenImageDenoise.find(Optional.of(Path.of("/none")), Map.of()))
        .hasMessageContaining("/none")
        .hasMessageEndingWith("state its path in LUMBRE_OIDN");
  }

  /** Runs only where the real program is installed. */
  @Test
  void theResultIsThatOfTheProgramItself() throws Exception {
    Optional<OpenImageDenoise> real = real();
    Assumptions.assumeTrue(real.isPresent(), "oidnDenoise is not installed");
    NoisyPicture picture = random();
    float[] ours = real.get().withThreads(1).denoise(picture).image().rgb();
    write("c.pfm", picture, picture.light());
    write("a.pfm", picture, picture.albedo().get());
    write("n.pfm", picture, picture.normal().get());
    byHand(real.get(), "--alb", "a.pfm", "-o", "a2.pfm");
    byHand(real.get(), "--nrm", "n.pfm", "-o", "n2.pfm");
    byHand(
        real.get(),
        "--hdr",
        "c.pfm",
        "--alb",
        "a2.pfm",
        "--nrm",
        "n2.pfm",
        "--clean_aux",
        "-o",
        "o.pfm");
    float[] byHand = LinearReader.read(folder.resolve("o.pfm")).rgb();
    for (int i = 0; i < byHand.length; i++) {
      assertThat(ours[i]).isEqualTo(Math.max(0, byHand[i]));
    }
  }

  private static Optional<OpenImageDenoise> real() {
    try {
      return Optional.of(OpenImageDenoise.find(Optional.empty(), System.getenv()));
    } catch (DenoiseException e) {
      return Optional.empty();
    }
  }

  private static NoisyPicture random() {
    Random random = new Random(5);
    float[] light = new float[3 * 40 * 30];
    for (int i = 0; i < light.length; i++) {
      light[i] = random.nextFloat();
    }
    NoisyPicture.Halves halves = new NoisyPicture.Halves(light, new float[0]);
    return new NoisyPicture(
        40, 30, halves, Optional.of(halves), Optional.of(halves), new float[0], 0);
  }

  private void write(String name, NoisyPicture picture, NoisyPicture.Halves values)
      throws IOException {
    ImageWriter.write(
        new Image(picture.width(), picture.height(), values.mean(), new float[0]),
        folder.resolve(name));
  }

  private void byHand(OpenImageDenoise real, String... arguments) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(real.program().toString());
    command.addAll(Arrays.asList(arguments));
    command.addAll(List.of("--threads", "1"));
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    assertThat(process.waitFor()).isZero();
  }
}
