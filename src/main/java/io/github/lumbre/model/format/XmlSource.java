package io.github.lumbre.model.format;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;

/** The bytes of an XML text in UTF-8, block by block. Mutable. */
public interface XmlSource {
  /** Returns the name of what is read, for messages; empty for the file of the model itself. */
  String part();

  /**
   * Reads the next bytes.
   *
   * @param from index in the target of the first byte
   * @return the number of bytes that were read; 0 at the end, or if the target is full
   * @throws ModelFormatException if they are damaged
   */
  int read(byte[] target, int from) throws ModelFormatException;

  /**
   * Returns the bytes of a model's file.
   *
   * @param text not copied
   * @param start index of its first byte
   */
  static XmlSource of(byte[] text, int start) {
    return new XmlSource() {
      private int at = start;

      @Override
      public String part() {
        return "";
      }

      @Override
      public int read(byte[] target, int from) {
        Interrupts.check();
        int count = Math.min(text.length - at, target.length - from);
        System.arraycopy(text, at, target, from, count);
        at += count;
        return count;
      }
    };
  }
}
