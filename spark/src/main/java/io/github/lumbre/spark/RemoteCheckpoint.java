package io.github.lumbre.spark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileContext;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Options.Rename;
import org.apache.hadoop.fs.Path;

/**
 * A checkpoint file on a Hadoop file system ({@code hdfs://}, {@code s3a://}, {@code file:/}). The
 * command line saves a local file; a thread copies each saved version to the file system, and
 * {@link #close} copies the last one. A reader finds the old version or the new one, complete: it
 * is written beside the old one and renamed, or put as one object where a store has no renames.
 */
final class RemoteCheckpoint implements AutoCloseable {
  /** Stores that show an object only when it is complete, and copy to rename. */
  private static final Set<String> OBJECT_STORES = Set.of("s3", "s3a", "s3n", "gs", "oss", "cos");

  private static final long POLL_MILLIS = 500;

  private final java.nio.file.Path local;
  private final Path remote;
  private final Configuration configuration;
  private final Consumer<String> warnings;
  private final Thread copier;
  private FileTime copied = FileTime.fromMillis(0);
  private volatile boolean isClosed;

  private RemoteCheckpoint(
      java.nio.file.Path local,
      URI remote,
      Configuration configuration,
      Consumer<String> warnings) {
    this.local = local;
    this.remote = new Path(remote);
    this.configuration = configuration;
    this.warnings = warnings;
    copier = new Thread(this::copyWhileRunning, "lumbre-checkpoint");
    copier.setDaemon(true);
  }

  /** Returns the URI that an argument is; empty for a plain path. */
  static Optional<URI> uri(String argument) {
    return argument.matches("[a-z][a-z0-9+.-]+:/.*")
        ? Optional.of(URI.create(argument))
        : Optional.empty();
  }

  /**
   * Replaces a checkpoint's URI in the arguments of a command by a local file, and copies that file
   * from now on.
   *
   * @param command arguments of {@code render} or {@code resume}; changed
   * @return empty if they have no URI
   * @throws IOException if a checkpoint to be resumed cannot be read, or one to be made exists
   */
  static Optional<RemoteCheckpoint> of(
      List<String> command, Configuration configuration, Consumer<String> warnings)
      throws IOException {
    int at = command.get(0).equals("resume") ? 1 : command.indexOf("--checkpoint") + 1;
    if (at == 0 || at >= command.size() || uri(command.get(at)).isEmpty()) {
      return Optional.empty();
    }
    URI uri = uri(command.get(at)).get();
    FileSystem files = FileSystem.get(uri, configuration);
    java.nio.file.Path local =
        Files.createTempDirectory("lumbre-checkpoint-").resolve(new Path(uri).getName());
    RemoteCheckpoint checkpoint = new RemoteCheckpoint(local, uri, configuration, warnings);
    boolean resumes = command.get(0).equals("resume");
    if (resumes) {
      files.copyToLocalFile(false, checkpoint.remote, new Path(local.toUri()), true);
      checkpoint.copied = Files.getLastModifiedTime(local);
    } else if (files.exists(checkpoint.remote)) {
      throw new IOException(uri + ": already exists; 'resume " + uri + "' continues it");
    }
    command.set(at, local.toString());
    checkpoint.copier.start();
    return Optional.of(checkpoint);
  }

  private void copyWhileRunning() {
    try {
      while (!isClosed) {
        Thread.sleep(POLL_MILLIS);
        try {
          copyIfNew();
        } catch (IOException e) {
          warnings.accept("warning: " + remote + ": cannot be written, and is tried again: " + e);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private synchronized void copyIfNew() throws IOException {
    if (!Files.exists(local)) {
      return;
    }
    FileTime saved = Files.getLastModifiedTime(local);
    if (!saved.equals(copied)) {
      copy();
      copied = saved;
    }
  }

  private void copy() throws IOException {
    FileSystem files = FileSystem.get(remote.toUri(), configuration);
    files.setWriteChecksum(false);
    Path from = new Path(local.toUri());
    String scheme = String.valueOf(files.getUri().getScheme());
    if (OBJECT_STORES.contains(scheme)) {
      files.copyFromLocalFile(false, true, from, remote);
      return;
    }
    Path beside = new Path(remote.getParent(), "." + remote.getName() + ".tmp");
    files.copyFromLocalFile(false, true, from, beside);
    FileContext.getFileContext(files.getUri(), configuration)
        .rename(beside, remote, Rename.OVERWRITE);
  }

  /**
   * Copies the last version.
   *
   * @throws UncheckedIOException if that fails; the message names the local file, which is kept
   */
  @Override
  public void close() {
    isClosed = true;
    try {
      copyIfNew();
    } catch (IOException e) {
      throw new UncheckedIOException(
          remote + ": cannot be written; the checkpoint file is kept as " + local, e);
    }
    try {
      Files.deleteIfExists(local);
      Files.deleteIfExists(local.resolveSibling(local.getFileName() + ".bak"));
      Files.deleteIfExists(local.getParent());
    } catch (IOException e) {
      warnings.accept("warning: " + local.getParent() + ": cannot be deleted: " + e);
    }
  }
}
