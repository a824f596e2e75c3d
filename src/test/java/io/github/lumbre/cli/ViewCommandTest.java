package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code lumbre view} on the command line. */
class ViewCommandTest {
  private static final Pattern ADDRESS = Pattern.compile("http://127\\.0\\.0\\.1:\\d+/\\w{32}/");

  @TempDir private Path directory;

  @Test
  void printsTheAddressAndServesUntilItIsStopped() throws Exception {
    String scene = TinyScene.write(directory, TinyScene.JSON).toString();
    Outcome.of("render", scene, "-o", directory + "/a.exr", "--checkpoint", directory + "/a.film");
    for (String file : new String[] {scene, directory + "/a.exr", directory + "/a.film"}) {
      StringWriter out = new StringWriter();
      StringWriter err = new StringWriter();
      String[] line = {"view", file, "--no-open", "--compare", directory + "/a.exr"};
      Thread command =
          new Thread(
              () -> Lumbre.run(line, new PrintWriter(out, true), new PrintWriter(err, true)));
      command.start();
      while (command.isAlive() && !ADDRESS.matcher(out.toString()).find()) {
        Thread.sleep(20);
      }
      assertThat(err.toString()).isEmpty();
      assertThat(out.toString().lines())
          .hasSize(1)
          .first()
          .asString()
          .startsWith("view: open http");
      Matcher address = ADDRESS.matcher(out.toString());
      assertThat(address.find()).isTrue();
      byte[] page = URI.create(address.group()).toURL().openStream().readAllBytes();
      assertThat(new String(page, StandardCharsets.UTF_8)).contains("<h1");
      command.interrupt();
      command.join(20_000);
      assertThat(command.isAlive()).isFalse();
    }
  }

  @Test
  void modelsRecordWhatDenoisingNeeds() throws Exception {
    ModelSample.write(directory);
    StringWriter out = new StringWriter();
    String[] line = {"view", directory + "/sample.glb", "--no-open", "--size", "24x18"};
    Thread command =
        new Thread(() -> Lumbre.run(line, new PrintWriter(out, true), new PrintWriter(out, true)));
    command.start();
    while (command.isAlive() && !ADDRESS.matcher(out.toString()).find()) {
      Thread.sleep(20);
    }
    Matcher address = ADDRESS.matcher(out.toString());
    assertThat(address.find()).as(out.toString()).isTrue();
    byte[] state = URI.create(address.group() + "state").toURL().openStream().readAllBytes();
    assertThat(new String(state, StandardCharsets.UTF_8))
        .contains("\"recorded\":[\"variance\",\"denoisingAlbedo\",\"denoisingNormal\"]");
    command.interrupt();
    command.join(20_000);
    assertThat(command.isAlive()).isFalse();
  }

  @Test
  void refusesBeforeItServes() throws Exception {
    Path scene = TinyScene.write(directory, TinyScene.JSON);
    Outcome missing = Outcome.of("view", "missing.json", "--no-open");
    assertThat(missing.exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(missing.err()).contains("expected a scene file, found none");
    assertThat(missing.out()).isEmpty();
    Outcome.of("view", "missing.exr", "--no-open").assertFailed(ExitCodes.SCENE, "missing.exr");
    Outcome.of("view", "-", "--no-open").assertFailed(ExitCodes.USAGE, "standard input");
    Outcome.of("view", scene + "", "--port", "70000").assertFailed(ExitCodes.USAGE, "--port");
    Outcome.of("view", scene + "", "--share", "0/2").assertFailed(ExitCodes.USAGE, "--share");
    Path text = Files.writeString(directory.resolve("x.png"), "no picture");
    Outcome.of("view", text + "").assertFailed(ExitCodes.ASSET, "x.png");
    Outcome.of("view", scene + "", "--compare", text + "").assertFailed(ExitCodes.ASSET, "x.png");
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      Outcome.of("view", scene + "", "--no-open", "--port", "" + taken.getLocalPort())
          .assertFailed(ExitCodes.OUTPUT, "--port", "choose another");
    }
  }
}
