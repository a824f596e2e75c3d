package io.github.lumbre.cli.mcp;

import java.util.ArrayList;
import java.util.List;

/** Writes the answers to the messages of a batch together, once all are there. Thread-safe. */
final class Batch {
  private final Answers answers;
  private final List<Object> together = new ArrayList<>();

  /** The requests without an answer, and the reader of the batch itself. */
  private int open = 1;

  Batch(Answers answers) {
    this.answers = answers;
  }

  /** Returns what gets the answer to one more message. */
  synchronized Receiver next() {
    open++;
    return new Receiver() {
      @Override
      public void answered(Object answer) {
        close(List.of(answer));
      }

      @Override
      public void cancelled() {
        close(List.of());
      }
    };
  }

  /** Ends the list of messages. */
  void end() {
    close(List.of());
  }

  private void close(List<Object> more) {
    boolean isComplete;
    synchronized (this) {
      together.addAll(more);
      isComplete = --open == 0 && !together.isEmpty();
    }
    if (isComplete) {
      answers.write(together);
    }
  }
}
