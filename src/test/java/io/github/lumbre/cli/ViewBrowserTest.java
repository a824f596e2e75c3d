package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.view.SceneSource;
import io.github.lumbre.cli.view.View;
import io.github.lumbre.cli.view.ViewLimits;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The page of {@code lumbre view} in a browser: what it shows, and what a mouse and keys do.
 * Screenshots are in {@code target/browser}.
 */
@Tag("browser")
class ViewBrowserTest {
  private static final Path FOLDER = Path.of("target", "browser");
  private static final long PATIENCE_NANOS = 90_000_000_000L;

  private static Browser browser;

  @TempDir private Path directory;
  private Path scene;
  private View view;
  private Thread runner;
  private final AtomicBoolean isEnd = new AtomicBoolean();

  private SceneFile read(Set<Layer> layers) throws SceneFormatException, TaskException {
    try {
      return new SceneParser()
          .overriding(
              s -> s.toBuilder().size(120, 90).samples(64).set(Setting.LAYERS, layers).build())
          .parse(scene);
    } catch (IOException e) {
      throw new TaskException(ExitCode.SCENE, e.getMessage(), e);
    }
  }

  private SceneSource source() {
    return new SceneSource() {
      @Override
      public SceneFile read(Set<Layer> layers) throws SceneFormatException, TaskException {
        return ViewBrowserTest.this.read(layers);
      }

      @Override
      public byte[] text() throws IOException {
        return Files.readAllBytes(scene);
      }

      @Override
      public Set<Path> files() {
        return Set.of(scene);
      }
    };
  }

  @BeforeAll
  static void openBrowser() throws Exception {
    Files.createDirectories(FOLDER);
    browser = Browser.start();
  }

  @AfterAll
  static void closeBrowser() throws Exception {
    if (browser != null) {
      browser.close();
    }
  }

  @BeforeEach
  void start() throws Exception {
    scene = Files.copy(Path.of("scenes/cornell-box.json"), directory.resolve("cornell-box.json"));
    start(Optional.empty());
  }

  /** Starts a page with the picture of a PNG file to compare with. */
  private void restart(Image image) throws Exception {
    end();
    isEnd.set(false);
    start(Optional.of(new View.Picture(image, List.of(), Map.of(), true)));
  }

  private void start(Optional<View.Picture> other) throws Exception {
    view = View.of(source(), new View.Options(scene, 0, other, other.isPresent() ? "d.png" : ""));
    view.open(ViewLimits.NONE);
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

  @AfterEach
  void end() throws Exception {
    // Leave the page first: it would complain that the server has gone.
    browser.open(URI.create("about:blank"), 800, 600, false);
    isEnd.set(true);
    runner.join();
    view.close();
  }

  private void open(int width, int height, boolean isDark) throws Exception {
    browser.open(view.address(), width, height, isDark);
  }

  private static void await(String condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!browser.evaluate("String(" + condition + ")").equals("true")) {
      assertThat(System.nanoTime()).as(condition).isLessThan(end);
      Thread.sleep(100);
    }
  }

  private static void awaitFinished() throws InterruptedException {
    await(
        "document.getElementById('status').textContent === 'Finished'"
            + " && document.getElementById('picture').dataset.final === 'true'");
  }

  /** Returns the pixels of the canvas as red, green and blue, of all pixels in order. */
  private static byte[] canvas() {
    String text =
        browser.evaluate(
            """
            (() => {
              const c = document.getElementById('picture');
              const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
              let s = '';
              for (let i = 0; i < d.length; i += 4) s += String.fromCharCode(d[i], d[i + 1], d[i + 2]);
              return btoa(s);
            })()
            """);
    return Base64.getDecoder().decode(text);
  }

  private static void mouse(String type, double x, double y) {
    browser.send(
        "Input.dispatchMouseEvent",
        Map.of("type", type, "x", x, "y", y, "button", "left", "clickCount", 1, "buttons", 1));
  }

  private static void key(String key) {
    browser.send("Input.dispatchKeyEvent", Map.of("type", "keyDown", "key", key));
    browser.send("Input.dispatchKeyEvent", Map.of("type", "keyUp", "key", key));
  }

  private static double[] center() {
    String[] words =
        browser
            .evaluate(
                "(() => { const b = document.getElementById('picture').getBoundingClientRect();"
                    + " return `${b.left + b.width / 2} ${b.top + b.height * .7}`; })()")
            .split(" ");
    return new double[] {Double.parseDouble(words[0]), Double.parseDouble(words[1])};
  }

  @Test
  void convergedPictureHasTheBytesOfThePngInEveryToneCurve() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    await("document.querySelector('#chart .estimate') !== null");
    SceneFile file = read(Set.of());
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    for (ToneCurve curve : ToneCurve.values()) {
      for (String exposure : new String[] {"0", "1.5", "auto"}) {
        browser.evaluate(
            """
            (() => {
              const set = (id, v) => { const e = document.getElementById(id); e.value = v; return e; };
              document.getElementById('auto').checked = '%2$s' === 'auto';
              if ('%2$s' !== 'auto') set('exposure', '%2$s');
              set('tone', '%1$s').dispatchEvent(new Event('change'));
              return '';
            })()
            """
                .formatted(curve.label(), exposure));
        Exposure stops =
            exposure.equals("auto") ? Exposure.AUTO : Exposure.of(Double.parseDouble(exposure));
        if (exposure.equals("auto")) {
          double doublings = Math.log(stops.factor(image)) / Math.log(2);
          await("document.getElementById('stops').textContent === '%.1f'".formatted(doublings));
        }
        byte[] png = image.toPng(new ImageWriter.Options(stops, curve, 8, Map.of()));
        BufferedImage expected = ImageIO.read(new ByteArrayInputStream(png));
        byte[] found = canvas();
        int different = 0;
        for (int i = 0; i < found.length; i++) {
          int rgb = expected.getRGB(i / 3 % 120, i / 3 / 120);
          int wanted = rgb >> 16 - 8 * (i % 3) & 0xff;
          int difference = Math.abs(wanted - (found[i] & 0xff));
          assertThat(difference).as("%s %s %d", curve, exposure, i).isLessThanOrEqualTo(1);
          different += difference;
        }
        // Of powers and logarithms, browsers round the last bit in their own way.
        assertThat(different).as("%s %s", curve, exposure).isLessThanOrEqualTo(3);
      }
    }
    browser.photograph(FOLDER.resolve("view-wide.png"));
    assertThat(browser.complaints()).isEmpty();
    assertThat(browser.requests()).allMatch(url -> url.startsWith(view.address().toString()));
  }

  @Test
  void clickDrawsPaths() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    double[] at = center();
    mouse("mouseMoved", at[0], at[1]);
    mouse("mousePressed", at[0], at[1]);
    mouse("mouseReleased", at[0], at[1]);
    await("document.querySelectorAll('#overlay circle').length > 0");
    assertThat(browser.evaluate("document.getElementById('text').textContent"))
        .matches("(?s)pixel 60,6[23], sample .*");
    await("document.querySelectorAll('#vertices li').length > 0");
    await("document.getElementById('values').textContent.includes('60, 6')");
    assertThat(
            browser.evaluate(
                "String([...document.querySelectorAll('aside dd')].every(e =>"
                    + " e.getBoundingClientRect().right <= screen.width - 16))"))
        .isEqualTo("true");
    browser.photograph(FOLDER.resolve("view-paths.png"));
    key("Escape");
    await("document.getElementById('paths').hidden");
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void dragTurnsTheCamera() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    byte[] before = canvas();
    double[] at = center();
    mouse("mousePressed", at[0], at[1]);
    for (int i = 1; i <= 6; i++) {
      mouse("mouseMoved", at[0] + 12 * i, at[1] - 3 * i);
      Thread.sleep(60);
    }
    mouse("mouseReleased", at[0] + 72, at[1] - 18);
    await("!document.getElementById('home').hidden");
    awaitFinished();
    await("document.getElementById('picture').width === 120");
    assertThat(canvas()).isNotEqualTo(before);
    browser.photograph(FOLDER.resolve("view-turned.png"));
    browser.evaluate("(document.getElementById('camera').click(), '')");
    await("document.getElementById('cameratext').textContent.includes('localRotation')");
    browser.photograph(FOLDER.resolve("view-camera.png"));
    browser.evaluate("(document.getElementById('closejson').click(), '')");
    key("h");
    await("document.getElementById('home').hidden");
    awaitFinished();
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!Arrays.equals(canvas(), before)) {
      assertThat(System.nanoTime()).isLessThan(end);
      Thread.sleep(100);
    }
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void objectsAreColoredAndNamed() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    byte[] light = canvas();
    browser.evaluate(
        """
        (() => {
          const list = document.getElementById('layer');
          list.value = 'object';
          list.dispatchEvent(new Event('change'));
          return '';
        })()
        """);
    await("document.getElementById('layer').selectedOptions[0].textContent === 'object'");
    awaitFinished();
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (colors(canvas()) > 3000 || Arrays.equals(canvas(), light)) {
      assertThat(System.nanoTime()).isLessThan(end);
      Thread.sleep(100);
    }
    double[] at = center();
    mouse("mouseMoved", at[0], at[1]);
    mouse("mouseMoved", at[0] + 1, at[1]);
    await("/[a-z] ?[a-z]+.*100 %/i.test(document.getElementById('values').textContent)");
    browser.photograph(FOLDER.resolve("view-objects.png"));
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void denoisedPictureIsShownByAKey() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    byte[] noisy = canvas();
    key("n");
    await("document.getElementById('layer').value === 'denoised'");
    await("document.getElementById('status').textContent === 'Finished, denoised at 64 samples'");
    await("document.getElementById('layer').selectedOptions[0].textContent === 'denoised'");
    byte[] denoised = canvas();
    assertThat(denoised).isNotEqualTo(noisy);
    browser.photograph(FOLDER.resolve("view-denoised.png"));
    key("k");
    await("!document.getElementById('second').hidden");
    key("n");
    awaitFinished();
    assertThat(canvas()).isEqualTo(noisy);
    assertThat(text("othercaption")).isEqualTo("the picture denoised at 64 samples");
    browser.photograph(FOLDER.resolve("view-denoised-side.png"));
    // A page that is opened now shows the denoised picture at once.
    open(1280, 800, false);
    await("document.getElementById('status').textContent === 'Finished, denoised at 64 samples'");
    assertThat(canvas()).isEqualTo(denoised);
    assertThat(browser.complaints()).isEmpty();
  }

  /** Returns the number of different colors. */
  private static long colors(byte[] rgb) {
    return IntStream.range(0, rgb.length / 3)
        .map(i -> rgb[3 * i] << 16 ^ rgb[3 * i + 1] << 8 ^ rgb[3 * i + 2])
        .distinct()
        .count();
  }

  @Test
  void keptPictureIsCompared() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    key("k");
    await("!document.getElementById('second').hidden");
    browser.photograph(FOLDER.resolve("view-side.png"));
    key("d");
    await("document.getElementById('mode').value === 'diff'");
    assertThat(canvas()).containsOnly((byte) 0);
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void picturesOfOtherSizesKeepTheirShapeAndColors() throws Exception {
    float[] gray = new float[3 * 50 * 50];
    Arrays.fill(gray, (float) Srgb.decode(200 / 255.));
    restart(new Image(50, 50, gray, new float[0]));
    open(1280, 800, false);
    awaitFinished();
    choose("tone", "agx");
    choose("mode", "side");
    browser.photograph(FOLDER.resolve("view-other-size.png"));
    assertThat(text("othercaption")).isEqualTo("d.png, 50×50 pixels");
    assertThat(text("caption")).isEqualTo("cornell-box.json, 120×90 pixels");
    assertThat(text("comparison")).contains("50×50", "120×90");
    choose("mode", "diff");
    assertThat(text("caption")).startsWith("no difference: d.png has 50×50 pixels");
    choose("mode", "other");
    byte[] shown = canvas();
    assertThat(shown).hasSize(3 * 120 * 90);
    assertThat(shown[3 * (45 * 120 + 14)]).as("left of the picture").isZero();
    assertThat(shown[3 * (45 * 120 + 60)]).isEqualTo((byte) 200);
    assertThat(shown[3 * 60]).as("at the top").isEqualTo((byte) 200);
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void aPngHasNoDifferenceFromWhatThePageShows() throws Exception {
    SceneFile file = read(Set.of());
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    byte[] png =
        image.toPng(new ImageWriter.Options(Exposure.of(1), ToneCurve.NEUTRAL, 8, Map.of()));
    restart(LinearReader.decode(png));
    open(1280, 800, false);
    awaitFinished();
    choose("tone", "neutral");
    browser.evaluate(
        "(() => { const e = document.getElementById('exposure'); e.value = 1; e.oninput();"
            + " return ''; })()");
    choose("mode", "diff");
    byte[] difference = canvas();
    int bright = 0;
    for (byte value : difference) {
      bright += (value & 255) > 30 ? 1 : 0;
    }
    assertThat(bright).as("values that differ by more than rounding").isZero();
    assertThat(text("comparison")).startsWith("Compared with d.png, as shown: mean absolute");
    choose("tone", "agx");
    assertThat(canvas()).isNotEqualTo(difference);
  }

  @Test
  void theChartNeedsTwoEstimates() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    assertThat(
            browser.evaluate(
                """
                (() => {
                  const chart = document.getElementById('chart');
                  const isHidden = (...points) => {
                    drawChart(chart, points);
                    return chart.parentNode.hidden;
                  };
                  return [isHidden(), isHidden([1, 16, .1, .2]),
                    isHidden([1, 16, .1, .2], [1.01, 16, .1, .2]),
                    isHidden([1, 16, .1, .2], [2, 32, .05, .1])].join();
                })()
                """))
        .isEqualTo("true,true,true,false");
    assertThat(browser.complaints()).isEmpty();
  }

  private static String text(String id) {
    return browser.evaluate("document.getElementById('" + id + "').textContent");
  }

  private static void choose(String list, String value) throws InterruptedException {
    await("!document.getElementById('" + list + "').disabled");
    browser.evaluate(
        """
        (() => {
          const list = document.getElementById('%s');
          list.value = '%s';
          list.dispatchEvent(new Event('change'));
          return '';
        })()
        """
            .formatted(list, value));
  }

  @Test
  void savedSceneIsShownAndPicturesAreSaved() throws Exception {
    open(1280, 800, false);
    awaitFinished();
    byte[] before = canvas();
    browser.evaluate(
        """
        (() => {
          const link = document.getElementById('png');
          link.addEventListener('click', e => e.preventDefault());
          link.click();
          fetch(link.href).then(a => a.arrayBuffer()).then(b => { window.saved = b.byteLength; });
          return '';
        })()
        """);
    await("window.saved > 1000");
    String text = Files.readString(scene);
    Files.writeString(scene, text.substring(0, text.length() / 2));
    await("!document.getElementById('problems').hidden");
    browser.photograph(FOLDER.resolve("view-problem.png"));
    assertThat(canvas()).isEqualTo(before);
    Files.writeString(scene, text.replaceFirst("\"intensity\": *[0-9.]+", "\"intensity\": 3"));
    await("document.getElementById('problems').hidden");
    awaitFinished();
    assertThat(browser.complaints()).isEmpty();
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({"narrow, 360, 740, false", "dark, 1100, 760, true", "tablet, 768, 1024, false"})
  void pageFitsTheScreen(String name, int width, int height, boolean isDark) throws Exception {
    open(width, height, isDark);
    awaitFinished();
    browser.photograph(FOLDER.resolve("view-" + name + ".png"));
    String outside =
        "[...document.querySelectorAll('button,select,input,h1,h2,canvas,dd')].filter(e => {"
            + " const b = e.getBoundingClientRect();"
            + " return b.width > 2 && (b.left < 0 || b.right > screen.width + 1); })"
            + ".map(e => e.id || e.textContent).join()";
    assertThat(browser.evaluate(outside)).isEmpty();
    assertThat(browser.evaluate("String(document.documentElement.scrollWidth <= screen.width)"))
        .isEqualTo("true");
    if (width > 760) {
      assertThat(browser.evaluate("String(document.documentElement.scrollHeight)"))
          .isEqualTo(String.valueOf(height));
    }
    assertThat(browser.complaints()).isEmpty();
  }

  /** Runs axe-core, whose script {@code -Daxe=.../axe.min.js} names, on the page in each state. */
  @ParameterizedTest
  @CsvSource({"1280, false", "360, true"})
  void pageIsAccessible(int width, boolean isDark) throws Exception {
    String script = System.getProperty("axe", "");
    assumeThat(script).as("-Daxe=FILE").isNotEmpty();
    open(width, 800, isDark);
    awaitFinished();
    double[] at = center();
    mouse("mousePressed", at[0], at[1]);
    mouse("mouseReleased", at[0], at[1]);
    await("document.querySelectorAll('#vertices li').length > 0");
    browser.evaluate(Files.readString(Path.of(script)) + "; ''");
    for (String dialog : new String[] {"", "keys"}) {
      if (!dialog.isEmpty()) {
        browser.evaluate("(document.getElementById('keys').showModal(), '')");
      }
      browser.evaluate("(window.found = null, axe.run().then(r => window.found = r), '')");
      await("window.found !== null");
      String violations =
          "window.found.violations.map(v => v.id + ': ' + v.nodes.map(n => n.html).join(' ;"
              + " ')).join('\\n"
              + "')";
      assertThat(browser.evaluate(violations)).isEmpty();
      assertThat(browser.evaluate("String(window.found.passes.length > 10)")).isEqualTo("true");
    }
  }
}
