package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.Signals;
import io.github.lumbre.file.OutputFile;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.parser.SceneFormatException;
import java.io.InterruptedIOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Lets SIGINT, SIGTERM and SIGHUP end a command early instead of losing its result. The first
 * signal stops what is being read or rendered, and the command saves what it has. A second SIGINT
 * or SIGTERM ends the program at once; a second SIGHUP does not, since the end of a terminal sends
 * several. Shared by the render's threads and those that handle signals.
 *
 * <p>A command that does not listen is ended by the first signal. However the program ends, it
 * deletes the temporary files of outputs that are not complete.
 */
public final class Interruption implements AutoCloseable {
  private static final Map<String, Integer> EXIT_CODES =
      Map.of(
          "INT", ExitCodes.INTERRUPTED,
          "TERM", ExitCodes.TERMINATED,
          "HUP", ExitCodes.HUNG_UP);

  /** How long a command without a result may take to end by itself. */
  private static final long PATIENCE_MILLIS = 1000;

  /** The exit code of the first signal; 0 before that. */
  private static final AtomicInteger FIRST = new AtomicInteger();

  private static final AtomicReference<Optional<Interruption>> LISTENING =
      new AtomicReference<>(Optional.empty());

  private final CountDownLatch closed = new CountDownLatch(1);
  private boolean rendering;
  private Optional<Thread> waiting = Optional.empty();
  private volatile boolean requested;

  private Interruption() {}

  /** Something that reads a scene, and ends with an exception when its thread is interrupted. */
  @FunctionalInterface
  public interface Reading<T> {
    T read() throws TaskException, SceneFormatException;
  }

  /** Something that ends with an exception when its thread is interrupted. */
  @FunctionalInterface
  interface Waiting<T> {
    T get() throws InterruptedException;
  }

  /** Handles signals from now on until the program ends. */
  public static void install() {
    EXIT_CODES.forEach((name, code) -> Signals.on(name, () -> arrived(code)));
    Runtime.getRuntime()
        .addShutdownHook(new Thread(OutputFile::deleteUnfinished, "lumbre-clean-up"));
  }

  /** Returns the exit code of a program whose command ended with a code of its own. */
  public static int exitCode(int ofCommand) {
    int signal = FIRST.get();
    boolean hasFailed = ofCommand > ExitCodes.TARGET && ofCommand != ExitCodes.INTERRUPTED;
    return signal == 0 || hasFailed ? ofCommand : signal;
  }

  private static void arrived(int code) {
    if (!FIRST.compareAndSet(0, code)) {
      if (code != ExitCodes.HUNG_UP) {
        ProgressBar.vanish();
        OutputFile.deleteUnfinished();
        Runtime.getRuntime().halt(code);
      }
      return;
    }
    Optional<Interruption> listening = LISTENING.get();
    if (listening.isEmpty() || !listening.get().letCommandEnd()) {
      ProgressBar.vanish();
      System.exit(code);
    }
  }

  /** Begins to listen. */
  public static Interruption listen() {
    Interruption interruption = new Interruption();
    LISTENING.set(Optional.of(interruption));
    return interruption;
  }

  /** Tells whether the program is to end. */
  boolean isRequested() {
    return requested;
  }

  /** From now on there is something to save; returns false if the program is ending already. */
  public synchronized boolean beginRender() {
    rendering = !requested;
    return rendering;
  }

  /**
   * From now on there is something to save.
   *
   * @throws TaskException if the program is ending already
   */
  public void requireRender() throws TaskException {
    if (!beginRender()) {
      throw new TaskException(
          Kind.STOPPED, "stopped before anything was rendered; no picture is written");
    }
  }

  @Override
  public void close() {
    if (!requested) {
      LISTENING.set(Optional.empty());
    }
    closed.countDown();
  }

  /**
   * Reads a scene, and ends that when the program is to end or the time has passed.
   *
   * @throws TaskException also if that happened
   */
  <T> T reading(Deadline deadline, Reading<T> action) throws TaskException, SceneFormatException {
    Optional<Thread> alarm = beginWaiting(deadline);
    try {
      return action.read();
    } catch (TaskException e) {
      throw e.getCause() instanceof InterruptedIOException ? stoppedReading() : e;
    } finally {
      endWaiting(alarm);
    }
  }

  /** Returns what a computation makes; empty if the program is to end or the time has passed. */
  <T> Optional<T> unlessStopped(Deadline deadline, Waiting<T> action) {
    Optional<Thread> alarm = beginWaiting(deadline);
    try {
      return Optional.of(action.get());
    } catch (InterruptedException e) {
      return Optional.empty();
    } finally {
      endWaiting(alarm);
    }
  }

  private TaskException stoppedReading() {
    return requested
        ? new TaskException(
            Kind.STOPPED, "stopped before anything was rendered; no picture is written")
        : new TaskException(
            Kind.LIMIT,
            "--timeout: the time was over before anything was rendered; no picture is written");
  }

  /** Interrupts this thread from now on, when the program is to end or the time has passed. */
  private synchronized Optional<Thread> beginWaiting(Deadline deadline) {
    waiting = Optional.of(Thread.currentThread());
    if (requested || deadline.hasPassed()) {
      interruptWaiting();
    }
    return deadline.secondsLeft().stream().mapToObj(this::alarm).findAny();
  }

  private Thread alarm(double seconds) {
    Thread alarm =
        new Thread(
            () -> {
              try {
                TimeUnit.NANOSECONDS.sleep((long) (1e9 * seconds));
                interruptWaiting();
              } catch (InterruptedException e) {
                // Nobody waits any more.
                return;
              }
            },
            "lumbre-alarm");
    alarm.setDaemon(true);
    alarm.start();
    return alarm;
  }

  private synchronized void interruptWaiting() {
    waiting.ifPresent(Thread::interrupt);
  }

  private synchronized void endWaiting(Optional<Thread> alarm) {
    waiting = Optional.empty();
    alarm.ifPresent(Thread::interrupt);
    // The command writes its outputs next, which an interrupted thread cannot.
    Thread.interrupted();
  }

  /** Asks the command to end; returns false if it has nothing to save and does not end. */
  private boolean letCommandEnd() {
    if (request()) {
      return true;
    }
    try {
      return closed.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Asks the command to stop; returns whether it has something to save. */
  private synchronized boolean request() {
    requested = true;
    interruptWaiting();
    return rendering;
  }
}
