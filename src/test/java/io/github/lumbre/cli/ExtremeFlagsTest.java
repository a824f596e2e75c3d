package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Every number of a flag, however large, small or wrong, gives a picture or a clear refusal. */
class ExtremeFlagsTest {
  private static final String OBJ =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

  /** Flags of commands below that take no number. */
  private static final Pattern OTHERS =
      Pattern.compile(
          "--(output|assets|format|checkpoint|denoiser|oidn|tonemap|layers?|camera|sky|background"
              + "|look|hidden|page|labels|variant|fit|hide|highlight|up|mode|guide|filter|quality"
              + "|kernel|progress|animation|ffmpeg|import-with|fallback-dir|scene|compare|root|png|error-map"
              + "|knobs|without|json|csv|scenes|sheet|shell)");

  /** A place for a number in the flags of {@code render}. */
  private static final String[] OF_MODELS = {
    "--view N,0",
    "--view 0,N",
    "--view iso --fov N",
    "--view iso --zoom N",
    "--view 1,2 --zoom N",
    "--eye N,1,2",
    "--eye 1,2,N --parallel",
    "--eye 1,2,3 --target 0,N,0",
    "--sky-intensity N",
    "--sky-intensity N --exposure auto",
    "--sky-intensity N --ground --background transparent",
    "--sky-rotation N",
    "--sky sun --sun N,5",
    "--sky sun --sun 5,N",
    "--sky sun --sun N,8@2026-06-21T12:00Z",
    "--sky sun --sun 48,N@2026-06-21T12:00Z",
    "--look lines --line-width N",
    "--look lines --crease N",
    "--view front --scale N:2",
    "--view front --scale 1:N",
    "--section x=N",
    "--section y=N%",
    "--section -z=N",
    "--section 0,0,N/1,1,0",
    "--section 0,0,0/N,1,0",
    "--section N,N,N/N,N,N",
    "--unit N",
    "--unit N --section x=0",
    "--unit N --labels all --up z",
    "--unit N --look clay,lines",
    "--unit N --ground --sky sun",
    "--points N",
    "--explode N",
    "--explode 0..N --fps 1",
    "--pose lift@N --view iso",
    "--animation lift --fps N --frames 0",
    "--animation lift --fps 2 --frames N",
    "--animation lift --fps 2 --frames 0/N",
    "--animation lift --fps 2 --frames 0 --shutter N",
    "--pose lift@0.5 --view iso --shutter 1 --poses N",
    "--turntable N --frames 0",
    "--turntable 2 --frames 0..N"
  };

  private static final String[] OF_ALL = {
    "--exposure N",
    "--clamp N",
    "--depth N",
    "--split N",
    "--samples N",
    "--samples-from N",
    "--samples-to N",
    "--seed N",
    "--bits N",
    "--jpeg-quality N",
    "--max-pixels N",
    "--threads N",
    "--bucket N",
    "--size N",
    "--size Nx2",
    "--size 2xN",
    "--crop N,0,2,2",
    "--crop 0,0,N,2",
    "--share N/2",
    "--share 0/N",
    "--target-error N%",
    "--target-error 50% --confidence N%",
    "--time Ns --samples 1",
    "--timeout Nh",
    "--denoise-timeout Ns",
    "--checkpoint-interval Ns"
  };

  @TempDir private Path folder;

  @BeforeEach
  void files() throws IOException {
    Files.writeString(folder.resolve("a.obj"), OBJ);
    TinyTable.write(folder);
    ModelSample.write(folder);
  }

  private void run(String line) {
    for (String value : Extremes.VALUES) {
      Extremes.run(Outcome.words(folder, line.replaceAll("N(?![A-Za-z])|(?<=[ /@=])N", value)));
    }
  }

  private void render(String model, String flags) {
    String size = flags.contains("--size") ? "" : " --size 8x6";
    String samples = flags.contains("--samples") ? "" : " -s 1";
    String fixed = "render T/" + model + " --no-denoise --overwrite -o T/o.png";
    run(fixed + size + samples + " " + flags);
  }

  @Test
  void flagsOfModels() {
    for (String flags : OF_MODELS) {
      boolean isAnimated = flags.contains("lift") || flags.contains("--fov");
      render(isAnimated ? "sample.glb" : "a.obj", flags);
    }
  }

  @Test
  void flagsOfRenders() {
    for (String flags : OF_ALL) {
      render("tiny.json", flags);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "check T/a.obj --unit N",
        "audit T/a.obj --size 4x3 --unit N",
        "audit T/a.obj --size 4x3 --sky-intensity N",
        "views T/sample.glb -o T/v --no-denoise --size 4x3 --samples N",
        "views T/sample.glb -o T/v --no-denoise --samples 1 --size N",
        "render T/a.obj --sheet T/o.png --overwrite --no-denoise -s 1 --size N",
        "views T/a.obj -o T/v --no-denoise -s 1 --size 4x3 --sky-intensity N",
        "diff T/a.obj T/a.obj --tolerance N",
        "diff T/a.obj T/sample.glb --tolerance N",
        "pixel T/tiny.json N,0",
        "pixel T/tiny.json 0,N",
        "pixel T/tiny.json 0,0 --sample N",
        "view T/tiny.json --no-open --compare T/none.png --port N",
        "trade T/none.json -o T/t.html --time Ns",
        "trade T/none.json -o T/t.html --samples N",
        "trade T/none.json -o T/t.html --reference N",
        "trade T/none.json -o T/t.html --seeds N",
        "trade T/none.json -o T/t.html --size 2xN",
        "perf T/none.json --samples N",
        "perf T/none.json --size Nx2",
        "perf T/none.json --threads N",
        "perf T/none.json --warmup N",
        "perf T/none.json --repeat N",
        "perf T/none.json --pairs N",
        "perf T/none.json --split N",
        "benchmark --scenes T --rows N",
        "benchmark --scenes T --rows 4 --scale N",
        "benchmark --scenes T --threads N",
        "benchmark --scenes T --warmup N",
        "benchmark --scenes T --repeat N"
      })
  void flagsOfOtherCommands(String line) {
    run(line);
  }

  @Test
  void flagsOfFilms() {
    String film = " --size 8x6 -s 2 --layers all --checkpoint T/a.film -o T/b.png";
    assertThat(Outcome.in(folder, "render T/tiny.json" + film).exitCode()).isZero();
    run("merge T/a.film -o T/o.png --overwrite --exposure N");
    run("merge T/a.film -o T/o.png --overwrite --bits N");
    run("develop T/a.film -o T/o.jpg --overwrite --jpeg-quality N");
    run("develop T/a.film -o T/o.png --overwrite --denoise-timeout Nm");
    run("resume T/a.film --samples N --time 1s -o T/o.pfm");
    run("resume T/a.film --target-error N% --samples 2 -o T/o.pfm");
    run("develop T/a.film -o T/a.exr");
    run("denoise T/a.exr -o T/o.png --overwrite --threads N");
    run("compare T/a.exr T/a.exr --tolerance rmse=N");
  }

  /** A new flag with a number belongs into a list above. */
  @Test
  void everyFlagWithAValueIsTried() {
    String tried = String.join(" ", OF_MODELS) + " " + String.join(" ", OF_ALL) + " --tolerance";
    String others = " --sample --port --reference --seeds --warmup --repeat --pairs --rows --scale";
    Set<String> missing = new TreeSet<>();
    for (CommandLine command : Lumbre.commandLine().getSubcommands().values()) {
      for (OptionSpec flag : command.getCommandSpec().options()) {
        boolean isTried =
            (tried + others + " ").matches(".*(^| )" + flag.longestName() + " .*")
                || OTHERS.matcher(flag.longestName()).matches();
        if (flag.arity().max() > 0 && !isTried) {
          missing.add(command.getCommandName() + " " + flag.longestName());
        }
      }
    }
    assertThat(missing).isEmpty();
  }
}
