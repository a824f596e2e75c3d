package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.TinyScene;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Visible;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.stopping.BudgetWatch;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Pictures;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import java.util.logging.Handler;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import java.util.logging.StreamHandler;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** The server of the local page: what it shows, what it does, and what it refuses. */
class ViewServerTest {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  /** A stalled client is closed within 2 s; the rest is for the test itself on a busy machine. */
  private static final Duration CLOSED = Duration.ofSeconds(4);

  @TempDir private Path directory;
  private Path scene;
  private View view;
  private Thread runner;
  private final AtomicBoolean isEnd = new AtomicBoolean();
  private final ByteArrayOutputStream logged = new ByteArrayOutputStream();
  private int samples = 64;
  private boolean isModel;

  /** Reads the scene of the test. */
  private final class Source implements SceneSource {
    @Override
    public SceneFile read(Set<Layer> layers) throws SceneFormatException, TaskException {
      try {
        SceneParser parser =
            new SceneParser()
                .overriding(
                    s -> s.toBuilder().samples(samples).set(Setting.LAYERS, layers).build());
        // A scene around a model is not read from a file.
        return isModel ? parser.parse(text(), scene) : parser.parse(scene);
      } catch (IOException e) {
        throw new TaskException(ExitCode.SCENE, e.getMessage(), e);
      }
    }

    @Override
    public byte[] text() throws IOException {
      return Files.readAllBytes(scene);
    }

    @Override
    public Set<Path> files() {
      return Set.of(scene);
    }
  }

  /** An answer, read from a socket so that no client forbids a header. */
  private record Reply(int status, Map<String, String> headers, byte[] body) {
    String text() {
      return new String(body, StandardCharsets.UTF_8);
    }
  }

  @BeforeEach
  void write() {
    scene = TinyScene.write(directory, TinyScene.JSON);
  }

  @AfterEach
  void end() throws InterruptedException {
    isEnd.set(true);
    if (runner != null) {
      runner.join();
    }
    if (view != null) {
      view.close();
    }
  }

  private View.Options options() {
    return new View.Options(scene, 0, Optional.empty(), "");
  }

  private void start() throws Exception {
    start(ViewLimits.NONE);
  }

  private void start(ViewLimits limits) throws Exception {
    start(new Source(), limits);
  }

  private void start(SceneSource source, ViewLimits limits) throws Exception {
    view = View.of(source, options());
    view.open(limits);
    runner =
        new Thread(
            () -> {
              try {
                view.run(isEnd::get);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    runner.start();
  }

  private Reply send(String method, String path, String body, String... headers)
      throws IOException {
    URI address = view.address();
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort())) {
      socket.setSoTimeout(30_000);
      List<String> lines = new ArrayList<>(List.of(method + " " + path + " HTTP/1.1"));
      lines.addAll(List.of(headers));
      if (lines.stream().noneMatch(line -> line.startsWith("Host:"))) {
        lines.add("Host: 127.0.0.1:" + address.getPort());
      }
      lines.add("Connection: close");
      if (!body.isEmpty()) {
        lines.add("Content-Length: " + body.length());
      }
      String request = String.join("\r\n", lines) + "\r\n\r\n" + body;
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      socket.getOutputStream().flush();
      return reply(socket.getInputStream().readAllBytes());
    }
  }

  private static Reply reply(byte[] all) {
    String text = new String(all, StandardCharsets.ISO_8859_1);
    int end = text.indexOf("\r\n\r\n");
    Map<String, String> headers = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    String[] lines = text.substring(0, end).split("\r\n");
    for (String line : Arrays.copyOfRange(lines, 1, lines.length)) {
      headers.put(
          line.substring(0, line.indexOf(':')), line.substring(line.indexOf(':') + 1).trim());
    }
    int status = Integer.parseInt(lines[0].split(" ")[1]);
    return new Reply(status, headers, Arrays.copyOfRange(all, end + 4, all.length));
  }

  private Reply get(String path) throws IOException {
    return send("GET", view.address().getPath() + path, "");
  }

  private Reply act(String json) throws IOException {
    String origin = "Origin: http://127.0.0.1:" + view.address().getPort();
    return send("POST", view.address().getPath() + "do", json, origin);
  }

  private JsonObject state(long since) throws IOException {
    Reply reply = get("state?since=" + since);
    assertThat(reply.status()).as(reply.text()).isEqualTo(200);
    return JsonParser.parseString(reply.text()).getAsJsonObject();
  }

  private JsonObject await(Predicate<JsonObject> condition) throws IOException {
    long end = System.nanoTime() + PATIENCE_NANOS;
    JsonObject state = state(0);
    while (!condition.test(state)) {
      assertThat(System.nanoTime()).as(state.toString()).isLessThan(end);
      state = state(state.get("version").getAsLong());
    }
    return state;
  }

  private static boolean isFinished(JsonObject state) {
    return state.get("status").getAsString().equals("finished");
  }

  private float[] values(String query) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(get(query).body()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.position(20);
    float[] values = new float[bytes.remaining() / 4];
    bytes.asFloatBuffer().get(values);
    return values;
  }

  private float[] rendered(Path file) throws Exception {
    SceneFile read =
        new SceneParser().overriding(s -> s.toBuilder().samples(samples).build()).parse(file);
    return new PictureRenderer(read.settings()).render(read.scene()).rgb();
  }

  @Test
  void pageIsOneSmallFileThatLoadsNothing() throws Exception {
    start();
    Reply page = get("");
    assertThat(page.status()).isEqualTo(200);
    assertThat(page.body()).hasSizeLessThan(200_000);
    assertThat(page.text().replace("http://www.w3.org/2000/svg", "")).doesNotContain("://");
    assertThat(page.headers().get("Content-Security-Policy")).startsWith("default-src 'none'");
    assertThat(page.headers()).containsEntry("Cache-Control", "no-store");
    assertThat(page.headers()).doesNotContainKey("Access-Control-Allow-Origin");
  }

  @Test
  void finishedPictureHasTheBitsOfARender() throws Exception {
    start();
    JsonObject state = await(ViewServerTest::isFinished);
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));
    JsonObject render = state.getAsJsonObject("render");
    assertThat(render.get("samples").getAsDouble()).isEqualTo(64);
    assertThat(render.getAsJsonArray("errors")).isNotEmpty();
    assertThat(state.getAsJsonObject("frame").get("isFinal").getAsBoolean()).isTrue();
    SceneFile file = new Source().read(Set.of());
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    Path png = Files.write(directory.resolve("saved.png"), get("save?format=png&tone=aces").body());
    Path expected = directory.resolve("expected.png");
    ImageWriter.write(
        image, expected, new ImageWriter.Options(Exposure.NONE, ToneCurve.ACES, 8, Map.of()));
    assertThat(Pictures.pixels(png)).isEqualTo(Pictures.pixels(expected));
  }

  @Test
  void stoppedRenderContinuesToTheSameBits() throws Exception {
    samples = 3000;
    start();
    await(state -> state.has("frame") && !isFinished(state));
    act("{\"action\": \"stop\"}");
    JsonObject stopped = await(state -> state.get("status").getAsString().equals("stopped"));
    double before = stopped.getAsJsonObject("render").get("samples").getAsDouble();
    assertThat(before).isLessThan(3000);
    act("{\"action\": \"continue\"}");
    await(ViewServerTest::isFinished);
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));
  }

  @Test
  void turnedCameraIsCopiedAsJsonWithTheSameBits() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    act("{\"action\": \"move\", \"right\": 31.4, \"up\": 8.8, \"zoom\": 0.1, \"still\": true}");
    JsonObject state = await(s -> s.get("isMoved").getAsBoolean() && isFinished(s));
    assertThat(state.getAsJsonObject("frame").get("isDraft").getAsBoolean()).isFalse();
    float[] turned = values("image?exact=1");
    JsonObject camera = JsonParser.parseString(get("camera").text()).getAsJsonObject();
    JsonObject whole = JsonParser.parseString(TinyScene.JSON).getAsJsonObject();
    whole.getAsJsonArray("objects").set(0, camera);
    Path copy = Files.writeString(directory.resolve("turned.json"), whole.toString());
    assertThat(turned).isEqualTo(rendered(copy)).isNotEqualTo(rendered(scene));
    act("{\"action\": \"home\"}");
    await(s -> !s.get("isMoved").getAsBoolean() && isFinished(s));
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));
  }

  /** A command with the flags of models. */
  @Command(modelTransformer = SettingFlags.Adder.class)
  private static final class Staged {
    @Mixin private ModelFlags model;
  }

  /** Reads a model by the flags of a command line. */
  private SceneFile model(List<String> flags) throws SceneFormatException, IOException {
    Staged staged = new Staged();
    new CommandLine(staged).parseArgs(flags.toArray(String[]::new));
    SceneParser parser =
        new SceneParser().overriding(s -> s.toBuilder().size(30, 20).samples(2).build());
    return StagedModel.read(directory.resolve("a.obj"), staged.model.stage(), parser).scene();
  }

  /** The line that the page shows for a camera that was moved renders the page's picture. */
  @ParameterizedTest
  @ValueSource(strings = {"--view=front", "--view=20,30", "--eye=9,9,9 --parallel"})
  void turnedCameraOfAModelIsACommandLineWithTheSameBits(String camera) throws Exception {
    Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 6 0 0\nv 0 4 2\nf 1 2 3\n");
    List<String> first = new ArrayList<>(List.of(camera.split(" ")));
    first.add("--up=z");
    RenderLine line =
        new RenderLine(
            Path.of("a.obj"),
            first.stream().map(f -> new RenderLine.Flag(f.split("=")[0], List.of(f))).toList());
    SceneSource source =
        new SceneSource() {
          @Override
          public SceneFile read(Set<Layer> layers) throws SceneFormatException, IOException {
            return model(first);
          }

          @Override
          public byte[] text() throws IOException {
            return new byte[0];
          }

          @Override
          public Set<Path> files() {
            return Set.of();
          }

          @Override
          public Optional<RenderLine> command() {
            return Optional.of(line);
          }
        };
    start(source, ViewLimits.NONE);
    await(ViewServerTest::isFinished);
    assertThat(command())
        .isEqualTo("lumbre render a.obj " + camera + " --up=z -s 2 -o a.png");
    act("{\"action\": \"move\", \"right\": 31.4, \"up\": 8, \"zoom\": -0.3, \"still\": true}");
    await(s -> s.get("isMoved").getAsBoolean() && isFinished(s));
    List<String> words = List.of(command().split(" "));
    assertThat(words).startsWith("lumbre", "render", "a.obj", "--up=z", "--size", "30x20");
    List<String> flags = new ArrayList<>(words.subList(6, words.size() - 4));
    flags.add("--up=z");
    SceneFile again = model(flags);
    assertThat(values("image?exact=1"))
        .as("%s", words)
        .isEqualTo(new PictureRenderer(again.settings()).render(again.scene()).rgb());
  }

  private String command() throws IOException {
    return JsonParser.parseString(get("command").text())
        .getAsJsonObject()
        .get("command")
        .getAsString();
  }

  @Test
  void dragShowsDraftsAndEndsByItself() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    act("{\"action\": \"move\", \"right\": 5}");
    JsonObject draft = await(s -> s.getAsJsonObject("frame").get("isDraft").getAsBoolean());
    assertThat(draft.get("status").getAsString()).isEqualTo("moving");
    await(ViewServerTest::isFinished);
  }

  @Test
  void savedSceneIsRenderedAnewAndAnInvalidOneIsReported() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    float[] before = values("image?exact=1");
    TinyScene.write(directory, TinyScene.with("\"radius\": 1", "\"radius\": -1"));
    JsonObject broken = await(state -> !state.getAsJsonArray("problems").isEmpty());
    assertThat(broken.getAsJsonArray("problems").get(0).getAsString())
        .contains("$.objects[2].radius", "found -1");
    assertThat(values("image?exact=1")).isEqualTo(before);
    TinyScene.write(directory, TinyScene.with("\"radius\": 1", "\"radius\": 0.5"));
    await(state -> state.getAsJsonArray("problems").isEmpty() && isFinished(state));
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene)).isNotEqualTo(before);
  }

  @Test
  void layersAreRecordedOnRequest() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    assertThat(get("image?layer=normal").status()).isEqualTo(204);
    assertThat(get("image?layer=unknown").status()).isEqualTo(404);
    assertThat(act("{\"action\": \"record\", \"layer\": \"normal\"}").status()).isEqualTo(200);
    await(s -> s.getAsJsonObject("render").getAsJsonArray("recorded").size() == 1 && isFinished(s));
    assertThat(values("image?layer=normal&exact=1")).hasSize(3 * 16 * 12);
    byte[] exr = get("save?format=exr").body();
    assertThat(LayeredImage.of(exr).layer("normal")).isPresent();
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));
  }

  @Test
  void denoisedPictureHasTheBitsOfTheDenoiserAndLeavesTheSamplesAlone() throws Exception {
    start();
    act("{\"action\": \"record\", \"layer\": \"denoised\"}");
    await(s -> recorded(s).contains("denoisingNormal") && isFinished(s));
    assertThat(state(0).getAsJsonObject("frame").has("denoised")).isFalse();
    assertThat(get("image?exact=1").headers()).doesNotContainKey("Denoised-Samples");
    // A page that wants it finds none yet, and gets the noisy picture.
    assertThat(values("image?exact=1&denoised=1")).isEqualTo(rendered(scene));
    await(s -> s.getAsJsonObject("frame").has("denoised"));

    SceneFile file = new Source().read(Layer.FOR_DENOISING);
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    Film film = renderer.newFilm();
    new PassLoop(renderer, film)
        .run(
            new BudgetWatch(ViewLimits.NONE.budget(file.settings())),
            PassListener.NONE,
            Progress.NONE);
    Denoised denoised = BuiltInDenoiser.denoise(NoisyPicture.of(film), 1);
    assertThat(get("image?exact=1&denoised=1").headers()).containsEntry("Denoised-Samples", "64.0");
    assertThat(values("image?exact=1&denoised=1"))
        .isEqualTo(denoised.image().rgb())
        .isNotEqualTo(rendered(scene));
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));

    byte[] png = denoised.image().toPng(ImageWriter.Options.DEFAULT);
    byte[] saved = get("save?format=png&denoised=1").body();
    assertThat(pixels(saved)).isEqualTo(pixels(png));
    assertThat(new String(saved, StandardCharsets.ISO_8859_1)).contains(denoised.engine());
    assertThat(LayeredImage.of(get("save?format=exr&denoised=1").body()).layer("variance"))
        .isPresent();
  }

  @Test
  void runningRenderIsDenoisedAndAMovedCameraIsNoisyAgain() throws Exception {
    samples = RenderSettings.MAX_SAMPLES;
    start();
    String running = "state?denoised=1&since=0";
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!get(running).text().contains("\"denoised\":")) {
      assertThat(System.nanoTime()).isLessThan(end);
      Thread.sleep(50);
    }
    double first = Double.parseDouble(get("image?denoised=1").headers().get("Denoised-Samples"));
    assertThat(first).isGreaterThanOrEqualTo(2);
    act("{\"action\": \"move\", \"right\": 3, \"still\": true}");
    await(s -> !s.getAsJsonObject("frame").has("denoised"));
  }

  @Test
  void lightsAreShownByGroup() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    act("{\"action\": \"record\", \"layer\": \"lights\"}");
    await(s -> recorded(s).contains("lights.other") && isFinished(s));
    assertThat(values("image?layer=lights.other&exact=1")).hasSize(3 * 16 * 12);
    assertThat(values("image?layer=lights&exact=1"))
        .isEqualTo(values("image?layer=lights.other&exact=1"));
  }

  private static String recorded(JsonObject state) {
    return state.getAsJsonObject("render").getAsJsonArray("recorded").toString();
  }

  @Test
  void mattesHaveExactIdsAndNames() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    for (String layer : new String[] {"object", "material"}) {
      act("{\"action\": \"record\", \"layer\": \"" + layer + "\"}");
      await(s -> recorded(s).contains(layer) && isFinished(s));
      // Four values: ids and shares of two items. Halves would destroy the ids.
      float[] values = values("image?layer=" + layer + "&exact=0");
      assertThat(values).hasSize(4 * 16 * 12);
      JsonObject names =
          JsonParser.parseString(get("names?layer=" + layer).text()).getAsJsonObject();
      assertThat(names.size()).isPositive();
      int hits = 0;
      for (int i = 0; i < values.length; i += 4) {
        if (values[i + 1] > 0) {
          hits++;
          assertThat(names.has("%08x".formatted(Float.floatToRawIntBits(values[i])))).isTrue();
        }
      }
      assertThat(hits).isPositive();
    }
    assertThat(get("names?layer=normal").text()).isEqualTo("{}");
    assertThat(values("image?exact=1")).isEqualTo(rendered(scene));
  }

  @Test
  void targetErrorEndsTheRenderWithTheBitsOfTheSameRenderWithoutAPage() throws Exception {
    samples = RenderSettings.MAX_SAMPLES;
    ViewLimits limits = new ViewLimits(OptionalDouble.of(.1), .95, Optional.empty());
    start(limits);
    JsonObject state = await(ViewServerTest::isFinished);
    SceneFile file = new Source().read(Set.of());
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    Film film = renderer.newFilm();
    BudgetWatch watch = new BudgetWatch(limits.budget(file.settings()));
    new PassLoop(renderer, film).run(watch, PassListener.NONE, Progress.NONE);
    assertThat(watch.isMet()).isTrue();
    JsonObject render = state.getAsJsonObject("render");
    assertThat(render.get("samples").getAsDouble()).isEqualTo(film.meanSamples());
    assertThat(render.get("goal").getAsInt()).isEqualTo(-1);
    assertThat(values("image?exact=1")).isEqualTo(film.develop().rgb());
  }

  @Test
  void timeEndsTheRenderAndAMovedCameraStartsAnew() throws Exception {
    samples = RenderSettings.MAX_SAMPLES;
    start(new ViewLimits(OptionalDouble.empty(), .95, Optional.of(Duration.ofMillis(300))));
    JsonObject first = await(ViewServerTest::isFinished);
    assertThat(first.getAsJsonObject("render").get("samples").getAsDouble()).isPositive();
    assertThat(first.getAsJsonObject("render").get("secondsLeft").getAsDouble()).isZero();
    act("{\"action\": \"move\", \"right\": 3, \"still\": true}");
    await(s -> s.get("isMoved").getAsBoolean() && !isFinished(s));
    await(ViewServerTest::isFinished);
  }

  /** Models have the automatic exposure of a render: that of the pixels that objects cover. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void automaticExposureIsThatOfARender(boolean isOfModel) throws Exception {
    isModel = isOfModel;
    start();
    await(ViewServerTest::isFinished);
    SceneFile file = new Source().read(Set.of());
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    double whole = Exposure.AUTO.factor(image);
    Exposure expected = Visible.exposure(Exposure.AUTO, file, image);
    assertThat(Math.abs(expected.factor(image) / whole - 1) > .05).isEqualTo(isModel);
    Map<String, String> headers = get("image?exact=1&auto=1").headers();
    assertThat(headers).containsEntry("Automatic-Exposure", String.valueOf(expected.factor(image)));
    assertThat(get("image?exact=1").headers()).doesNotContainKey("Automatic-Exposure");
    byte[] saved = get("save?format=png&exposure=auto&tone=srgb").body();
    byte[] png = image.toPng(new ImageWriter.Options(expected, ToneCurve.SRGB, 8, Map.of()));
    assertThat(pixels(saved)).isEqualTo(pixels(png));
  }

  private static int[] pixels(byte[] png) throws IOException {
    return Pictures.pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  @Test
  void pixelHasPathsInThePicture() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    JsonObject pixel = JsonParser.parseString(get("pixel?x=8&y=8").text()).getAsJsonObject();
    assertThat(pixel.get("samples").getAsInt()).isEqualTo(64);
    JsonObject path = pixel.getAsJsonArray("brightest").get(0).getAsJsonObject();
    assertThat(path.get("text").getAsString()).startsWith("pixel 8,8, sample ");
    JsonObject first = path.getAsJsonArray("drawing").get(0).getAsJsonObject();
    assertThat(first.getAsJsonArray("to").get(0).getAsDouble()).isBetween(7.9, 9.1);
    assertThat(first.getAsJsonArray("to").get(1).getAsDouble()).isBetween(7.9, 9.1);
    assertThat(get("pixel?x=8&y=8&sample=5").text()).contains("\"sample\":5");
  }

  @Test
  void twoBrowsersSeeTheSame() throws Exception {
    start();
    await(ViewServerTest::isFinished);
    assertThat(values("image?exact=1")).isEqualTo(values("image?exact=1"));
    assertThat(state(0)).isEqualTo(state(0));
  }

  @Test
  void closedPageCostsNothingAndTheResultIsThere() throws Exception {
    samples = 20_000;
    start();
    await(state -> state.has("frame") && !isFinished(state));
    Thread.sleep(Viewers.PATIENCE_NANOS / 1_000_000 + 500);
    assertThat(view.session().viewers().areWatching()).isFalse();
    long version = view.session().frame().orElseThrow().version();
    Thread.sleep(700);
    boolean isDone = view.session().snapshot().status().equals("finished");
    if (!isDone) {
      assertThat(view.session().frame().orElseThrow().version()).isEqualTo(version);
    }
    act("{\"action\": \"stop\"}");
    await(state -> !state.get("status").getAsString().equals("rendering"));
    double shown = view.session().frame().orElseThrow().samples();
    await(state -> state.getAsJsonObject("frame").get("isFinal").getAsBoolean());
    assertThat(view.session().frame().orElseThrow().samples()).isGreaterThanOrEqualTo(shown);
  }

  @Test
  void othersAreRefused() throws Exception {
    start();
    String path = view.address().getPath();
    String own = "127.0.0.1:" + view.address().getPort();
    String stop = "{\"action\": \"stop\"}";
    assertThat(send("GET", "/", "").status()).isEqualTo(404);
    assertThat(send("GET", "/" + "0".repeat(32) + "/state", "").status()).isEqualTo(404);
    assertThat(send("GET", path, "", "Host: example.com").status()).isEqualTo(403);
    assertThat(send("GET", path + "state", "", "Origin: http://example.com").status())
        .isEqualTo(403);
    assertThat(send("POST", path + "do", stop).status()).isEqualTo(403);
    assertThat(send("POST", path + "do", stop, "Origin: http://example.com").status())
        .isEqualTo(403);
    assertThat(send("OPTIONS", path + "do", "", "Origin: http://example.com").status())
        .isEqualTo(403);
    assertThat(state(0).get("status").getAsString()).isNotEqualTo("stopped");
    String origin = "Origin: http://" + own;
    assertThat(send("POST", path + "do", " ".repeat(20_000), origin).status()).isEqualTo(413);
    assertThat(send("GET", path + "image?" + "x".repeat(3000), "").status()).isEqualTo(414);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          pixel?x=16&y=0       | x: expected a number from 0 to 15, found 16
          pixel?x=-1&y=0       | x: expected a number from 0 to 15, found -1
          pixel?x=a&y=0        | x: expected a number from 0 to 15, found a
          pixel?x=1.5&y=0      | x: expected a number from 0 to 15, found 1.5
          pixel?x=1&y=1&sample=99999999999 | sample: expected a number from 0 to 1073741823, found 99999999999
          state?since=x        | since: expected a number from 0 to 9223372036854775807, found x
          image?denoised=2     | denoised: expected a number from 0 to 1, found 2
          save?exposure=NaN    | exposure: expected a number from -64 to 64, found NaN
          save?exposure=zz     | exposure: expected a number from -64 to 64, found zz
          save?exposure=       | exposure: expected a number from -64 to 64, found
          save?exposure=1e9    | exposure: expected a number from -64 to 64, found 1e9
          save?tone=x          | tone: expected one of srgb, gamma22, reinhard, aces, neutral, agx, found x
          """)
  void wrongQuestionsAreAnsweredInPlainWords(String query, String answer) throws Exception {
    start();
    await(ViewServerTest::isFinished);
    Reply reply = get(query);
    assertThat(reply.status()).isEqualTo(400);
    assertThat(reply.text().strip()).isEqualTo(answer);
  }

  @Test
  void malformedAddressIsAnswered() throws Exception {
    start();
    assertThat(get("state?a=%zz").status()).isEqualTo(400);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "state", "image?exact=1", "save?exposure=1", "nothing", "pixel?x=99&y=0"})
  void headHasTheHeadersOfGetAndNoBody(String path) throws Exception {
    start();
    await(ViewServerTest::isFinished);
    Handler log = new StreamHandler(logged, new SimpleFormatter());
    Logger logger = Logger.getLogger("com.sun.net.httpserver");
    logger.addHandler(log);
    try {
      Reply got = get(path);
      Reply head = send("HEAD", view.address().getPath() + path, "");
      assertThat(head.status()).isEqualTo(got.status());
      assertThat(head.headers().keySet()).isEqualTo(got.headers().keySet());
      assertThat(head.headers().get("Content-Length")).isEqualTo(String.valueOf(got.body().length));
      assertThat(head.body()).isEmpty();
      assertThat(send("HEAD", "/", "").status()).isEqualTo(404);
    } finally {
      log.flush();
      logger.removeHandler(log);
    }
    assertThat(logged.toString(StandardCharsets.UTF_8)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "[]",
        "{\"action\": \"quit\"}",
        "{\"action\": {}}",
        "{\"action\": \"move\", \"right\": \"x\"}",
        "{\"action\": \"move\", \"right\": 1e300}",
        "{\"action\": \"move\", \"up\": [1, 2]}",
        "{\"action\": \"move\", \"still\": {}}",
        "{\"action\": \"record\"}",
        "{\"action\": \"record\", \"layer\": \"x\"}"
      })
  void wrongCommandsAreAnswered(String body) throws Exception {
    start();
    assertThat(act(body).status()).isEqualTo(400);
  }

  @Test
  void deepCommandIsAnswered() throws Exception {
    start();
    assertThat(act("[".repeat(16_000)).status()).isEqualTo(400);
  }

  @Test
  void portInUseIsReported() throws Exception {
    start();
    View.Options same = new View.Options(scene, view.address().getPort(), Optional.empty(), "");
    assertThatThrownBy(() -> View.of(new Source(), same))
        .isInstanceOf(TaskException.class)
        .hasMessageContaining("choose another port");
  }

  @Test
  void pictureIsShownAndComparedWithAnother() throws Exception {
    Image image = new Image(2, 1, new float[] {1, 2, 3, .1f, .2f, .3f}, new float[0]);
    View.Picture picture = new View.Picture(image, List.of(), Map.of(), false);
    View.Options options = new View.Options(scene, 0, Optional.of(picture), "other.exr");
    view = View.of(picture, Exposure.of(1), Exposure.AUTO, ToneCurve.AGX, options);
    view.open(ViewLimits.NONE);
    JsonObject state = state(0);
    assertThat(state.get("status").getAsString()).isEqualTo("still");
    assertThat(state.get("toneMap").getAsString()).isEqualTo("agx");
    assertThat(state.get("exposure").getAsDouble()).isEqualTo(1);
    assertThat(state.get("other").getAsString()).isEqualTo("other.exr");
    assertThat(values("image?exact=1")).containsExactly(1, 2, 3, .1f, .2f, .3f);
    assertThat(values("other")).containsExactly(1, 2, 3, .1f, .2f, .3f);
    assertThat(get("pixel?x=0&y=0").status()).isEqualTo(400);
    assertThat(act("{\"action\": \"move\", \"right\": 3}").status()).isEqualTo(200);
  }

  /** The page gets the color behind a picture with alpha, and saved files have it. */
  @Test
  void pictureIsShownAndSavedBeforeItsBackground() throws Exception {
    Image image = new Image(2, 1, new float[] {0, 0, 0, .2f, .2f, .2f}, new float[] {0, 1});
    Rgb coral = new Rgb(1, Srgb.fromByte(127), Srgb.fromByte(80));
    View.Picture picture = new View.Picture(image, List.of(), Map.of(), false, Optional.of(coral));
    View.Options options = new View.Options(scene, 0, Optional.empty(), "");
    view = View.of(picture, Exposure.of(1), Exposure.AUTO, ToneCurve.AGX, options);
    view.open(ViewLimits.NONE);
    assertThat(state(0).getAsJsonArray("background").get(1).getAsDouble()).isEqualTo(coral.g());
    Path png = Files.write(directory.resolve("saved.png"), get("save?format=png&tone=aces").body());
    assertThat(Pictures.pixels(png)[0]).isEqualTo(0xffff7f50);
    assertThat(picture.asLight().image().pixel(0, 0).r()).isEqualTo(1);
  }

  /** Half requests of a stalled, a dripping and a malicious client; the server stops to wait. */
  @ParameterizedTest
  @CsvSource({"8, HEADER", "60, HEADER", "200, HEADER", "60, BODY", "60, DRIP"})
  void stalledClientsAreTimedOutWhileThePageIsServed(int clients, String part) throws Exception {
    start();
    await(ViewServerTest::isFinished);
    String half = half(part);
    List<Socket> stalled = new ArrayList<>();
    AtomicBoolean isDripping = new AtomicBoolean(part.equals("DRIP"));
    try {
      long begin = System.nanoTime();
      for (int i = 0; i < clients; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), view.address().getPort());
        socket.getOutputStream().write(half.getBytes(StandardCharsets.US_ASCII));
        socket.setSoTimeout(10_000);
        stalled.add(socket);
      }
      Thread drip = new Thread(() -> drip(stalled, isDripping));
      drip.start();
      for (long wait = 0; wait < 1000; wait += 100) {
        assertThat(get("").status()).isEqualTo(200);
        Thread.sleep(100);
      }
      for (Socket socket : stalled) {
        assertThat(isClosed(socket)).isTrue();
      }
      assertThat(Duration.ofNanos(System.nanoTime() - begin)).isLessThan(CLOSED);
      isDripping.set(false);
      drip.join();
      assertThat(get("").status()).isEqualTo(200);
    } finally {
      isDripping.set(false);
      for (Socket socket : stalled) {
        socket.close();
      }
    }
  }

  private String half(String part) {
    String own = "127.0.0.1:" + view.address().getPort();
    return part.equals("BODY")
        ? "POST %sdo HTTP/1.1\r\nHost: %s\r\nOrigin: http://%s\r\nContent-Length: 99\r\n\r\n{"
            .formatted(view.address().getPath(), own, own)
        : "GET / HTTP/1.1\r\nHost: 127";
  }

  private static void drip(List<Socket> sockets, AtomicBoolean isOn) {
    while (isOn.get()) {
      for (Socket socket : sockets) {
        try {
          socket.getOutputStream().write('1');
        } catch (IOException e) {
          // The server has closed it, as it has to.
          continue;
        }
      }
    }
  }

  private static boolean isClosed(Socket socket) throws IOException {
    try {
      return socket.getInputStream().readAllBytes().length >= 0;
    } catch (SocketTimeoutException e) {
      return false;
    } catch (SocketException e) {
      return true;
    }
  }
}
