package io.github.lumbre.cli.mcp;

/** Gets the answer to a request, once; possibly in another thread. */
@FunctionalInterface
interface Receiver {
  void answered(Object answer);

  /** The request is cancelled and gets no answer. */
  default void cancelled() {}
}
