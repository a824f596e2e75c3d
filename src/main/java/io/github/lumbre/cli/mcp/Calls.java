package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.text.PrintableText;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Runs calls of tools, a few at once and the others in the order of their requests. A failure ends
 * its own call only. Thread-safe.
 */
final class Calls implements AutoCloseable {
  /** The calls that run at once: each may use all processors, and a slow one holds up none. */
  static final int RUNNING = 4;

  /** The calls that may wait. */
  static final int WAITING = 64;

  private static final long POLL_MILLIS = 100;

  private final Answers answers;
  private final Map<Object, Call> open = new ConcurrentHashMap<>();
  private final ThreadPoolExecutor pool;

  @FunctionalInterface
  interface Work {
    /**
     * Returns the result.
     *
     * @throws InterruptedException if the call is cancelled
     */
    Map<String, Object> result(CallProgress progress) throws InterruptedException;
  }

  Calls(Answers answers) {
    this.answers = answers;
    pool =
        new ThreadPoolExecutor(
            RUNNING,
            RUNNING,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(WAITING),
            work -> new Thread(work, "lumbre-mcp-call"));
  }

  /** A call from its request to its answer. */
  private final class Call implements Runnable {
    private final Object id;
    private final Optional<Object> token;
    private final Work work;
    private final Receiver to;
    private Optional<Thread> thread = Optional.empty();
    private boolean hasEnded;

    Call(Object id, Optional<Object> token, Work work, Receiver to) {
      this.id = id;
      this.token = token;
      this.work = work;
      this.to = to;
    }

    @Override
    public void run() {
      if (begin()) {
        CallProgress progress = new CallProgress(answers, token);
        Object answer = answer(progress);
        progress.end();
        finish(answer);
      }
    }

    private Object answer(CallProgress progress) {
      try {
        return Answers.result(id, work.result(progress));
      } catch (InterruptedException | RuntimeException | Error e) {
        return Answers.error(
            Optional.of(id),
            new RpcException(
                RpcException.INTERNAL_ERROR,
                "internal error: " + PrintableText.shortened(e.toString())));
      }
    }

    private synchronized boolean begin() {
      thread = Optional.of(Thread.currentThread());
      return !hasEnded;
    }

    private void finish(Object answer) {
      boolean isOpen;
      synchronized (this) {
        isOpen = end();
        thread = Optional.empty();
        Thread.interrupted(); // The thread runs other calls.
      }
      if (isOpen) {
        to.answered(answer);
      }
    }

    /** Ends the call; returns whether it had not ended. */
    private synchronized boolean end() {
      boolean wasOpen = !hasEnded;
      hasEnded = true;
      open.remove(id, this);
      return wasOpen;
    }

    private synchronized void cancel() {
      if (end()) {
        thread.ifPresent(Thread::interrupt);
        pool.remove(this);
        to.cancelled();
      }
    }
  }

  /**
   * Starts a call.
   *
   * @param id of the request
   * @param token with which the client wants to be told the progress; empty if it does not
   * @throws RpcException if a call with this identity runs, or too many wait
   */
  void start(Object id, Optional<Object> token, Work work, Receiver to) throws RpcException {
    Call call = new Call(id, token, work, to);
    if (open.putIfAbsent(id, call) != null) {
      throw new RpcException(
          RpcException.INVALID_REQUEST, "id: expected another one than of a call that runs");
    }
    try {
      pool.execute(call);
    } catch (RejectedExecutionException e) {
      open.remove(id, call);
      throw new RpcException(
          RpcException.INTERNAL_ERROR,
          "expected at most " + WAITING + " calls that wait; wait for some, or cancel them");
    }
  }

  /** Cancels a call; does nothing if no such call runs or waits. */
  void cancel(Object id) {
    Optional.ofNullable(open.get(id)).ifPresent(Call::cancel);
  }

  /** Waits for the calls that run or wait, as long as the client can be reached. */
  @Override
  public void close() {
    pool.shutdown();
    try {
      while (!pool.awaitTermination(POLL_MILLIS, TimeUnit.MILLISECONDS)) {
        if (answers.isBroken()) {
          pool.shutdownNow();
        }
      }
    } catch (InterruptedException e) {
      pool.shutdownNow();
      Thread.currentThread().interrupt();
    }
  }
}
