package io.github.lumbre.image;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.Locale;

/** Why a file could not be read or written, in words. */
public final class FileFailure {
  private FileFailure() {}

  /**
   * Returns the reason without the file's name, such as {@code permission denied}. The exceptions
   * of {@link java.nio.file.Files} often have the file's name as their only message.
   */
  public static String reason(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof NoSuchFileException) {
      return "no such file";
    }
    if (e instanceof NotDirectoryException) {
      return "not a directory";
    }
    if (e instanceof FileSystemLoopException) {
      return "symbolic links lead in a circle";
    }
    if (e instanceof CharacterCodingException) {
      return "not a text in UTF-8";
    }
    String message = e instanceof FileSystemException f ? f.getReason() : e.getMessage();
    if (message == null || message.isEmpty()) {
      return "the system gives no reason (" + e.getClass().getSimpleName() + ")";
    }
    return e instanceof ImageFormatException ? message : begunSmall(message);
  }

  /** Returns the system's own words, such as "Is a directory", as the rest of a sentence. */
  private static String begunSmall(String message) {
    boolean isWord = message.length() > 1 && Character.isLowerCase(message.charAt(1));
    return isWord
        ? message.substring(0, 1).toLowerCase(Locale.ROOT) + message.substring(1)
        : message;
  }
}
