package io.github.lumbre.stage.thumbnail;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.Stage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.Thread.UncaughtExceptionHandler;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests each way in which a call for a thumbnail ends. */
@Timeout(value = 5, unit = TimeUnit.MINUTES)
class ThumbnailsTest {
  private static final int SIDE = 32;
  private static final Limits LIMITS = Limits.UPLOADS.withTime(Duration.ofMinutes(2));

  /** Takes far longer than a thread needs to queue some calls. */
  private static final byte[] LONG = ThumbnailModels.stl(400_000);

  private static final byte[] SHORT = ThumbnailModels.stl(40);

  /** Returns as much memory for a model that one thread fits into the heap. */
  private static Limits forOneThread() {
    return LIMITS.withMemory(Runtime.getRuntime().maxMemory());
  }

  @Test
  void theSameModelGivesTheSamePictureToAllCallers() throws Exception {
    byte[] model = Files.readAllBytes(Path.of("scenes/models/lantern.glb"));
    ExecutorService callers = Executors.newFixedThreadPool(4);
    try (Thumbnails thumbnails = new Thumbnails(LIMITS);
        Thumbnails alone = new Thumbnails(Stage.DEFAULT, forOneThread())) {
      Callable<byte[]> call = () -> thumbnails.png("lantern.glb", model, SIDE);
      List<Future<byte[]>> pictures = callers.invokeAll(List.of(call, call, call, call));
      byte[] first = alone.png("lantern.glb", model, SIDE);
      for (Future<byte[]> picture : pictures) {
        assertThat(picture.get()).isEqualTo(first);
      }
      Pixels pixels = ImageReader.decode(first);
      assertThat(List.of(pixels.width(), pixels.height())).containsOnly(SIDE);
      assertThat(colors(pixels)).hasSizeGreaterThan(20);
    } finally {
      callers.shutdownNow();
    }
  }

  private static Set<Integer> colors(Pixels pixels) {
    return IntStream.range(0, SIDE * SIDE)
        .mapToObj(i -> pixels.raw(i % SIDE, i / SIDE, 0))
        .collect(Collectors.toSet());
  }

  /** The color behind a model is exact in a PNG, and within 2 of 255 in a JPEG. */
  @Test
  void theBackgroundHasItsColor() throws Exception {
    Stage stage = Stage.DEFAULT.onBackground(new Rgb(1, Srgb.fromByte(99), Srgb.fromByte(71)));
    try (Thumbnails thumbnails = new Thumbnails(stage, LIMITS)) {
      Pixels png = ImageReader.decode(thumbnails.png("a.stl", SHORT, SIDE));
      assertThat(png.hasAlpha()).isFalse();
      Pixels jpeg = ImageReader.decode(thumbnails.jpeg("a.stl", SHORT, SIDE));
      int[] expected = {255, 99, 71};
      for (int c = 0; c < 3; c++) {
        assertThat(png.raw(0, 0, c)).isEqualTo(expected[c]);
        assertThat(jpeg.raw(0, 0, c)).isCloseTo(expected[c], within(2));
      }
      assertThat(colors(png)).hasSizeGreaterThan(5);
    }
    assertThatThrownBy(() -> Stage.DEFAULT.onBackground(new Rgb(0, 1.5, 0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("background: expected components from 0 to 1");
  }

  @Test
  void aJpegIsGivenToo() throws Exception {
    try (Thumbnails thumbnails = new Thumbnails(LIMITS)) {
      byte[] jpeg = thumbnails.jpeg("a.stl", SHORT, SIDE);
      assertThat(thumbnails.jpeg("a.stl", new ByteArrayInputStream(SHORT), SIDE)).isEqualTo(jpeg);
      assertThat(ImageReader.decode(jpeg).width()).isEqualTo(SIDE);
      assertThat(jpeg).startsWith(0xff, 0xd8);
    }
  }

  /** The ending of a name may choose the format; nothing else of the name has an effect. */
  @Test
  void namesAreNotTrusted() throws Exception {
    try (Thumbnails thumbnails = new Thumbnails(LIMITS)) {
      byte[] picture = thumbnails.png("a.stl", SHORT, SIDE);
      for (String name : List.of("", "a", "../../etc/passwd", "a\0b.STL", "C:\\a.exe", "/")) {
        assertThat(thumbnails.png(name, SHORT, SIDE)).isEqualTo(picture);
      }
    }
  }

  @Test
  void damagedAndLargeModelsAreTheFaultOfTheFile() {
    try (Thumbnails thumbnails = new Thumbnails(LIMITS.withBytes(1000))) {
      byte[] damaged = "v a b c\nf 1 2 3\n".getBytes(StandardCharsets.US_ASCII);
      assertThat(fault(thumbnails, "evil\u001b[2J.obj", damaged))
          .hasMessageStartingWith("evil\\u001b[2J.obj: line 1: ")
          .extracting(SceneFormatException::kind)
          .isEqualTo(SceneFormatException.Kind.ASSET);
      assertThat(fault(thumbnails, "", new byte[10]))
          .hasMessageStartingWith("model: expected a model (.gltf, .glb, ");
      assertThat(fault(thumbnails, "a.stl", SHORT))
          .extracting(SceneFormatException::kind)
          .isEqualTo(SceneFormatException.Kind.LIMIT);
    }
  }

  @Test
  void errorsNameTheModelAsTheCallerDoes() {
    try (Thumbnails thumbnails = new Thumbnails(LIMITS)) {
      for (String name : List.of("duck.obj", "uploads/my duck.OBJ", "Ente №1.obj")) {
        byte[] damaged = "v a b c\nf 1 2 3\n".getBytes(StandardCharsets.US_ASCII);
        assertThat(fault(thumbnails, name, damaged).problems())
            .allSatisfy(problem -> assertThat(problem.file()).isEqualTo(name));
      }
    }
  }

  private static SceneFormatException fault(Thumbnails thumbnails, String name, byte[] model) {
    return catchThrowableOfType(
        SceneFormatException.class, () -> thumbnails.png(name, model, SIDE));
  }

  @Test
  void endlessStreamsAreCutAndFailedOnesAreReported() {
    InputStream endless =
        new InputStream() {
          private long count;

          @Override
          public int read() throws IOException {
            if (count++ > 1000) {
              throw new IOException("read too far");
            }
            return '\n';
          }
        };
    try (Thumbnails thumbnails = new Thumbnails(LIMITS.withBytes(1000))) {
      SceneFormatException refused =
          catchThrowableOfType(
              SceneFormatException.class, () -> thumbnails.png("a.obj", endless, SIDE));
      assertThat(refused.kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
      assertThatThrownBy(() -> thumbnails.png("a.obj", endless, SIDE))
          .isInstanceOf(IOException.class)
          .hasMessage("read too far");
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -1, Thumbnails.MAX_SIDE + 1, 65})
  void sizesOutOfRangeAreTheFaultOfTheCaller(int side) {
    try (Thumbnails thumbnails = new Thumbnails(LIMITS.withPixels(64 * 64))) {
      assertThatThrownBy(() -> thumbnails.png("a.stl", SHORT, side))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("side: expected ");
    }
  }

  /** The first calls may wait for the warm-up, so that the server is at fault. */
  @Test
  void aModelThatTakesTooLongIsTheFaultOfTheFile() throws Exception {
    Limits limits = LIMITS.withTime(Duration.ofMillis(50));
    try (Thumbnails thumbnails = new Thumbnails(limits)) {
      Throwable thrown = new RejectedExecutionException();
      while (thrown instanceof RejectedExecutionException) {
        thrown = catchThrowable(() -> thumbnails.png("a.stl", LONG, SIDE));
      }
      assertThat(thrown)
          .isInstanceOf(SceneFormatException.class)
          .hasMessage("a.stl: expected a model that is rendered within 0.05 s");
      assertThat(((SceneFormatException) thrown).kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
    }
  }

  @Test
  void callsThatWaitForOthersTooLongAreTheFaultOfTheServer() throws Exception {
    ExecutorService callers = Executors.newFixedThreadPool(8);
    Limits limits = forOneThread().withTime(Duration.ofMillis(300));
    try (Thumbnails thumbnails = new Thumbnails(limits)) {
      Callable<Throwable> call = () -> catchThrowable(() -> thumbnails.png("a.stl", LONG, SIDE));
      List<String> messages = new ArrayList<>();
      for (Future<Throwable> end : callers.invokeAll(Collections.nCopies(8, call))) {
        if (end.get() instanceof RejectedExecutionException e) {
          messages.add(e.getMessage());
        }
      }
      assertThat(messages).containsOnly("too busy to render a model within 0.3 s");
    } finally {
      callers.shutdownNow();
    }
  }

  @Test
  void callsBeyondTheQueueAreRejectedAtOnceAndTheOthersAtTheEnd() throws Exception {
    int calls = 140;
    ExecutorService callers = Executors.newFixedThreadPool(calls);
    try {
      List<Future<Throwable>> ends = new ArrayList<>();
      try (Thumbnails thumbnails = new Thumbnails(Stage.DEFAULT, forOneThread())) {
        for (int i = 0; i < calls; i++) {
          ends.add(callers.submit(() -> catchThrowable(() -> thumbnails.png("a.stl", LONG, SIDE))));
        }
        while (!anyIsRejected(ends)) {
          Thread.sleep(1);
        }
      }
      List<String> messages = new ArrayList<>();
      for (Future<Throwable> end : ends) {
        Throwable thrown = end.get();
        if (thrown != null) { // A fast machine renders some before the end.
          assertThat(thrown).isInstanceOf(RejectedExecutionException.class);
          messages.add(thrown.getMessage());
        }
      }
      assertThat(messages).contains("too many calls wait", "the thumbnails are closed");
    } finally {
      callers.shutdownNow();
    }
  }

  private static boolean anyIsRejected(List<Future<Throwable>> ends) throws Exception {
    for (Future<Throwable> end : ends) {
      if (end.isDone() && end.get() instanceof RejectedExecutionException) {
        return true;
      }
    }
    return false;
  }

  private static boolean haveThreadsEnded() {
    return Thread.getAllStackTraces().keySet().stream()
        .noneMatch(thread -> thread.getName().equals("lumbre-thumbnail"));
  }

  /** Warming up is interrupted wherever it is, and prints nothing. */
  @Test
  void closingSoonIsQuiet() throws InterruptedException {
    UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Queue<Throwable> uncaught = new ConcurrentLinkedQueue<>();
    Thread.setDefaultUncaughtExceptionHandler((thread, e) -> uncaught.add(e));
    try {
      for (int i = 0; i < 40; i++) {
        Thumbnails thumbnails = new Thumbnails(LIMITS);
        Thread.sleep(i % 10);
        thumbnails.close();
      }
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(before);
    }
    assertThat(uncaught).isEmpty();
  }

  @Test
  void anInterruptEndsTheCallAndCloseEndsAllThreads() throws Exception {
    Thumbnails thumbnails = new Thumbnails(LIMITS);
    ExecutorService caller = Executors.newSingleThreadExecutor();
    Future<Throwable> end =
        caller.submit(() -> catchThrowable(() -> thumbnails.png("a.stl", LONG, SIDE)));
    Thread.sleep(50);
    caller.shutdownNow();
    assertThat(end.get()).isInstanceOf(InterruptedException.class);
    assertThat(thumbnails.png("a.stl", SHORT, SIDE)).isNotEmpty();
    thumbnails.close();
    thumbnails.close();
    // A thread is alive for a moment after its pool has ended.
    for (int wait = 0; wait < 200 && !haveThreadsEnded(); wait++) {
      Thread.sleep(10);
    }
    assertThat(haveThreadsEnded()).isTrue();
    assertThatThrownBy(() -> thumbnails.png("a.stl", SHORT, SIDE))
        .isInstanceOf(RejectedExecutionException.class)
        .hasMessage("the thumbnails are closed");
  }
}
