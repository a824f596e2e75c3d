package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Locale;

/** Describes in words why a file could not be read or written. */
public final class FileFailure {
  /** The remedy if the locale's encoding cannot express a file name. */
  public static final String REMEDY = "set the environment variable LC_ALL to C.UTF-8";

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
    if (e instanceof FileAlreadyExistsException) {
      return "a file of this name exists";
    }
    if (e instanceof FileSystemLoopException) {
      return "symbolic links form a loop";
    }
    if (e instanceof CharacterCodingException) {
      return "not UTF-8 text";
    }
    String message = e instanceof FileSystemException f ? f.getReason() : e.getMessage();
    if (message == null || message.isEmpty()) {
      return "the system reports no reason (" + e.getClass().getSimpleName() + ")";
    }
    return begunSmall(message);
  }

  /** Returns an exception with the same reason that also states the file. */
  public static FileSystemException named(Path file, IOException e) {
    if (e instanceof FileSystemException named) {
      return named;
    }
    FileSystemException named = new FileSystemException(file.toString(), null, e.getMessage());
    named.initCause(e);
    return named;
  }

  /**
   * Returns why a text is not a path. Java takes the encoding of file names from the locale.
   * Without a locale it is ASCII, which has no other letters.
   */
  public static String reason(InvalidPathException e) {
    String encoding = System.getProperty("sun.jnu.encoding", "UTF-8");
    boolean isEncodable =
        Charset.isSupported(encoding)
            && Charset.forName(encoding).newEncoder().canEncode(e.getInput())
            && e.getInput().indexOf('\ufffd') < 0;
    return isEncodable
        ? begunSmall(e.getReason())
        : "the locale's encoding, " + encoding + ", cannot express this name; " + REMEDY;
  }

  /**
   * Returns the system's message, such as "Is a directory", with a lowercase first letter, so that
   * it can continue a sentence.
   */
  private static String begunSmall(String message) {
    // Keep names such as "OpenEXR" or "PNG".
    boolean isWord = message.split("[^\\p{L}]", 2)[0].matches("\\p{Lu}\\p{Ll}+");
    return isWord
        ? message.substring(0, 1).toLowerCase(Locale.ROOT) + message.substring(1)
        : message;
  }
}
