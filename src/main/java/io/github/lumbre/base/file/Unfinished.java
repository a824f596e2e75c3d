package io.github.lumbre.base.file;

import java.io.Closeable;
import java.io.IOException;

/** Something on the disk that must not outlive this process. */
interface Unfinished extends Closeable {
  /** Deletes it when the process ends, while another thread may still use it. */
  default void delete() throws IOException {
    close();
  }
}
