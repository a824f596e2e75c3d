package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.base.file.ProcessEnd;
import io.github.lumbre.base.limit.internal.TimeLimit;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.Signals;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Handles SIGINT, SIGTERM and SIGHUP so that a command ends early without losing its result. The
 * first signal stops loading or rendering, and the command saves its result so far. A second SIGINT
 * or SIGTERM exits the program immediately. A second SIGHUP does not, because a closing terminal
 * sends several. Shared by rendering threads and signal handlers.
 *
 * <p>The first signal exits a command that does not listen. In every case the program deletes the
 * temporary files of incomplete outputs.
 */
public final class Interruption implements AutoCloseable {
  private static final Map<String, ExitCode> EXIT_CODES =
      Map.of(
          "INT", ExitCode.INTERRUPTED,
          "TERM", ExitCode.TERMINATED,
          "HUP", ExitCode.HUNG_UP);

  /** The time that a command without a result has to end on its own. */
  private static final long PATIENCE_MILLIS = 1000;

  /**
   * The time after the first signal, or after the deadline, in which a picture that has all its
   * samples can still be completed.
   */
  static final Duration GRACE = Duration.ofSeconds(3);

  private final CountDownLatch closed = new CountDownLatch(1);
  private boolean rendering;
  private Optional<Thread> waiting = Optional.empty();
  private Optional<Thread> finishing = Optional.empty();
  private volatile boolean requested;
  private long requestedAt;

  private Interruption() {}

  /** A time in which a signal or the deadline interrupts a thread. */
  public interface Wait extends AutoCloseable {
    @Override
    void close();
  }

  /** An action that throws an exception when its thread is interrupted. */
  @FunctionalInterface
  public interface Waiting<T> {
    T get() throws InterruptedException;
  }

  /** Installs the signal handlers for the rest of the program. */
  public static void install() {
    EXIT_CODES.forEach((name, code) -> Signals.on(name, () -> arrived(code.number())));
    Runtime.getRuntime()
        .addShutdownHook(new Thread(OutputFile::deleteUnfinished, "lumbre-clean-up"));
  }

  /** Returns the exit code of the program, given the exit code of its command. */
  public static int exitCode(int ofCommand) {
    int signal = ProcessEnd.signal();
    boolean hasFailed =
        ofCommand > ExitCode.TARGET.number() && ofCommand != ExitCode.INTERRUPTED.number();
    return signal == 0 || hasFailed ? ofCommand : signal;
  }

  private static void arrived(int code) {
    if (!ProcessEnd.arrived(code)) {
      if (code != ExitCode.HUNG_UP.number()) {
        ProgressBar.vanish();
        OutputFile.deleteUnfinished();
        Runtime.getRuntime().halt(code);
      }
      return;
    }
    if (!letCommandsEnd(ProcessEnd.open(Interruption.class))) {
      ProgressBar.vanish();
      System.exit(code);
    }
  }

  /** Returns one that hears no signals: the first one exits the program. */
  public static Interruption none() {
    return new Interruption();
  }

  /** Starts to listen for signals. One that has arrived before counts, too. */
  public static Interruption listen() {
    Interruption interruption = ProcessEnd.add(new Interruption());
    if (ProcessEnd.signal() != 0) {
      interruption.request();
    }
    return interruption;
  }

  /** Returns whether a signal has requested the end of the program. */
  boolean isRequested() {
    return requested;
  }

  /** Marks that there is now a result to save. Returns false if the program is already ending. */
  public synchronized boolean beginRender() {
    rendering = !requested;
    return rendering;
  }

  /**
   * Marks that the result is saved, so that a signal ends the program even if reading the next
   * scene cannot be interrupted.
   */
  synchronized void endRender() {
    rendering = false;
  }

  /**
   * Marks that there is now a result to save.
   *
   * @throws CancellationException if the program is already ending
   */
  public void requireRender() {
    if (!beginRender()) {
      throw new CancellationException("stopped by a signal");
    }
  }

  @Override
  public void close() {
    if (!requested) {
      ProcessEnd.remove(this);
    }
    closed.countDown();
  }

  /** Lets a signal or the deadline interrupt this thread until the result is closed. */
  Wait waiting(Deadline deadline) {
    TimeLimit alarm = beginWaiting(deadline);
    return () -> {
      alarm.close();
      endWaiting();
    };
  }

  /** Returns the result of a computation; empty if a signal or the deadline stops it. */
  <T> Optional<T> unlessStopped(Deadline deadline, Waiting<T> action) {
    Wait wait = waiting(deadline);
    try (wait) {
      return Optional.of(action.get());
    } catch (InterruptedException | CancellationException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns the result of a step of a picture that has all its samples; empty if it is not done
   * within {@link #GRACE} after the first signal, or after the deadline.
   */
  <T> Optional<T> finishing(Deadline deadline, Waiting<T> action) {
    Duration left = beginFinishing(deadline);
    TimeLimit alarm = TimeLimit.start(left);
    try (alarm) {
      if (left.isNegative()) {
        return Optional.empty();
      }
      return Optional.of(action.get());
    } catch (InterruptedException | CancellationException e) {
      return Optional.empty();
    } finally {
      endFinishing();
    }
  }

  /**
   * Arranges that a signal interrupts this thread later.
   *
   * @return the time that the thread has now, negative if there is none
   */
  private synchronized Duration beginFinishing(Deadline deadline) {
    finishing = Optional.of(Thread.currentThread());
    Duration ofDeadline = deadline.left().plus(GRACE);
    Duration ofSignal = GRACE.minusNanos(requested ? System.nanoTime() - requestedAt : 0);
    return requested && ofSignal.compareTo(ofDeadline) < 0 ? ofSignal : ofDeadline;
  }

  private synchronized void interruptFinishing() {
    finishing.ifPresent(Thread::interrupt);
  }

  private synchronized void endFinishing() {
    finishing = Optional.empty();
    Thread.interrupted();
  }

  /** Arranges that a signal or the deadline interrupts this thread. */
  private synchronized TimeLimit beginWaiting(Deadline deadline) {
    waiting = Optional.of(Thread.currentThread());
    if (requested || deadline.hasPassed()) {
      interruptWaiting();
    }
    return TimeLimit.start(deadline.left());
  }

  private synchronized void interruptWaiting() {
    waiting.ifPresent(Thread::interrupt);
  }

  private synchronized void endWaiting() {
    waiting = Optional.empty();
    // The command writes its outputs next, and an interrupted thread cannot write.
    Thread.interrupted();
  }

  /**
   * Requests the end of commands. Returns false if none has a result to save and one does not end.
   */
  private static boolean letCommandsEnd(List<Interruption> commands) {
    boolean isSaving = false;
    for (Interruption command : commands) {
      isSaving |= command.request();
    }
    if (isSaving) {
      return true;
    }
    boolean haveEnded = !commands.isEmpty();
    try {
      for (Interruption command : commands) {
        haveEnded &= command.closed.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
    return haveEnded;
  }

  /** Requests the end of the command. Returns whether it has a result to save. */
  synchronized boolean request() {
    if (!requested) {
      requested = true;
      requestedAt = System.nanoTime();
      CompletableFuture.delayedExecutor(GRACE.toMillis(), TimeUnit.MILLISECONDS)
          .execute(this::interruptFinishing);
    }
    interruptWaiting();
    return rendering;
  }
}
