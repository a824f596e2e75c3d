package io.github.lumbre.cli.mcp;

import io.github.lumbre.render.Progress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Tells a client, a few times per second, how much of its call is done, if it asked for that.
 * Thread-safe.
 */
final class CallProgress implements Progress {
  private static final long PAUSE_NANOS = 250_000_000;

  private final Answers answers;
  private final Optional<Object> token;
  private final Thread caller = Thread.currentThread();
  private long last = System.nanoTime();
  private long total;
  private long done;
  private boolean hasEnded;

  /**
   * Creates it in the thread of the call.
   *
   * @param token with which the client wants to be told; empty if it does not
   */
  CallProgress(Answers answers, Optional<Object> token) {
    this.answers = answers;
    this.token = token;
  }

  /** States the samples of all pictures of the call, before the first one is rendered. */
  synchronized void expect(long samples) {
    total = samples;
  }

  @Override
  public synchronized void advanced(long samples) {
    done += samples;
    long now = System.nanoTime();
    if (token.isEmpty() || hasEnded || now - last < PAUSE_NANOS) {
      return;
    }
    last = now;
    Map<String, Object> params = new LinkedHashMap<>();
    params.put("progressToken", token.get());
    params.put("progress", done);
    params.put("total", Math.max(done, total));
    params.put("message", "samples");
    answers.write(Answers.notification("notifications/progress", params));
  }

  /** Ends the notifications. */
  synchronized void end() {
    hasEnded = true;
  }

  @Override
  public boolean isCancelled() {
    return caller.isInterrupted();
  }
}
