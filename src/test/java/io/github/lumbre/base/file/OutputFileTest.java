package io.github.lumbre.base.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.testing.Folders;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests that output files appear complete or not at all. */
class OutputFileTest {
  @TempDir Path directory;

  private static void put(OutputFile file, String text) throws IOException {
    file.restart().write(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
  }

  private List<String> names() throws IOException {
    return Folders.names(directory);
  }

  @Test
  void nothingAppearsBeforeCommit() throws IOException {
    Path target = directory.resolve("a.png");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      assertThat(target).doesNotExist();
      file.commit();
      assertThat(target).hasContent("new");
    }
    assertThat(names()).containsExactly("a.png");
  }

  @Test
  void closingWithoutCommitKeepsTheOldFile() throws IOException {
    Path target = Files.writeString(directory.resolve("a.png"), "old");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      assertThat(names()).hasSize(2);
    }
    assertThat(target).hasContent("old");
    assertThat(names()).containsExactly("a.png");
  }

  @Test
  void commitReplacesTheOldFile() throws IOException {
    Path target = Files.writeString(directory.resolve("a.png"), "a longer old text");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      file.commit();
    }
    assertThat(target).hasContent("new");
    assertThat(names()).containsExactly("a.png");
  }

  @Test
  void restartDiscardsWhatWasWritten() throws IOException {
    Path target = directory.resolve("a.png");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "a first attempt that failed");
      put(file, "second");
      file.commit();
    }
    assertThat(target).hasContent("second");
  }

  @Test
  void aFailedCommitCanBeRepeated() throws IOException {
    Path target = directory.resolve("a.png");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      Files.createDirectories(target.resolve("occupied"));
      assertThatThrownBy(file::commit).isInstanceOf(IOException.class);
      Files.delete(target.resolve("occupied"));
      Files.delete(target);
      file.commit();
    }
    assertThat(target).hasContent("new");
  }

  @Test
  void twoCannotWriteTheSameFileAtOnce() throws IOException {
    Path target = directory.resolve("a.png");
    try (OutputFile file = OutputFile.open(target)) {
      assertThatThrownBy(() -> OutputFile.open(target))
          .isInstanceOf(IOException.class)
          .hasMessage(target + ": another run is writing this file");
      put(file, "first");
      file.commit();
    }
    assertThat(target).hasContent("first");
    OutputFile.open(target).close();
  }

  @Test
  void whatAKilledRunLeftIsUsedUp() throws IOException {
    Files.writeString(directory.resolve(".a.png.tmp"), "half a picture, long");
    Path target = directory.resolve("a.png");
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      file.commit();
    }
    assertThat(target).hasContent("new");
    assertThat(names()).containsExactly("a.png");
  }

  @Test
  void missingDirectoriesAreMadeAndDeletedIfNothingIsWritten() throws IOException {
    Path target = directory.resolve("no/such/a.png");
    OutputFile.open(target).close();
    OutputFile.reserve(target).close();
    assertThat(directory).isEmptyDirectory();
    try (OutputFile file = OutputFile.open(target)) {
      put(file, "new");
      file.commit();
    }
    assertThat(target).hasContent("new");
    OutputFile.open(target.resolveSibling("b.png")).close();
    assertThat(target).exists();
  }

  @Test
  void aDirectoryThatCannotBeMadeIsNamed() throws IOException {
    Files.writeString(directory.resolve("file"), "");
    Path target = directory.resolve("file/such/a.png");
    assertThatThrownBy(() -> OutputFile.open(target))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(
            target + ": the directory " + target.getParent() + " cannot be created: ");
  }

  @Test
  void aDirectoryIsNoTarget() {
    assertThatThrownBy(() -> OutputFile.open(directory))
        .isInstanceOf(IOException.class)
        .hasMessage(directory + ": is a directory, expected a file");
  }

  @Test
  void aNameThatIsTooLongIsKnownAtOnce() {
    Path target = directory.resolve("a".repeat(300) + ".png");
    assertThatThrownBy(() -> OutputFile.open(target))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(target + ": ");
  }

  @Test
  void aDeviceIsNoTarget() {
    Path device = Path.of("/dev/null");
    assumeTrue(Files.exists(device));
    assertThatThrownBy(() -> OutputFile.open(device))
        .isInstanceOf(IOException.class)
        .hasMessage("/dev/null: is not a regular file");
  }

  @Test
  void aDirectoryThatCannotBeWrittenIsNamed() {
    // Not even the superuser can create files there.
    Path target = Path.of("/proc/self/a.png");
    assumeTrue(Files.isDirectory(target.getParent()));
    assertThatThrownBy(() -> OutputFile.open(target))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "/proc/self/a.png: the directory /proc/self cannot be written: its file system allows"
                + " no new files");
  }

  @Test
  void aSymbolicLinkStaysOne() throws IOException {
    Path real = Files.writeString(directory.resolve("real.png"), "old");
    Path link = directory.resolve("link.png");
    try {
      Files.createSymbolicLink(link, real);
    } catch (UnsupportedOperationException | IOException e) {
      assumeTrue(false, "no symbolic links here");
    }
    try (OutputFile file = OutputFile.open(link)) {
      put(file, "new");
      file.commit();
    }
    assertThat(link).isSymbolicLink().hasContent("new");
    assertThat(real).hasContent("new");
  }

  @Test
  void afterCommitNothingCanBeWritten() throws IOException {
    try (OutputFile file = OutputFile.open(directory.resolve("a.png"))) {
      file.commit();
      assertThatThrownBy(file::commit).isInstanceOf(IllegalStateException.class);
      assertThatThrownBy(file::restart).isInstanceOf(IllegalStateException.class);
    }
  }

  /** Records all disk operations, and writes one byte at a time. */
  private static class Recording implements Disk {
    final List<String> steps = new ArrayList<>();

    @Override
    public void write(FileChannel channel, ByteBuffer buffer) throws IOException {
      ByteBuffer one = buffer.slice().limit(1);
      buffer.get();
      channel.write(one);
    }

    @Override
    public void force(FileChannel channel) {
      steps.add("force");
    }

    @Override
    public void move(Path from, Path to) throws IOException {
      steps.add(from.getFileName() + " to " + to.getFileName());
      Disk.super.move(from, to);
    }

    @Override
    public void forceDirectory(Path parent) {
      steps.add("force " + parent.getFileName());
    }
  }

  private static ByteBuffer text(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void bytesAreOnTheDiskBeforeTheyHaveTheName() throws IOException {
    Recording disk = new Recording();
    try (OutputFile file = OutputFile.open(directory.resolve("a.png"), disk)) {
      file.write(text("all of it"));
      file.commit();
    }
    assertThat(disk.steps)
        .containsExactly("force", ".a.png.tmp to a.png", "force " + directory.getFileName());
    assertThat(directory.resolve("a.png")).hasContent("all of it");
  }

  @Test
  void previousFileIsKeptBesideTheNewOne() throws IOException {
    Path target = directory.resolve("a.film");
    Recording disk = new Recording();
    for (String content : new String[] {"first", "second", "third"}) {
      try (OutputFile file = OutputFile.open(target, disk)) {
        file.write(text(content));
        file.commitKeepingPrevious();
        assertThatThrownBy(file::commitKeepingPrevious).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> file.write(text("x"))).isInstanceOf(IllegalStateException.class);
      }
      assertThat(target).hasContent(content);
    }
    assertThat(OutputFile.previous(target)).hasFileName("a.film.bak").hasContent("second");
    assertThat(names()).containsExactly("a.film", "a.film.bak");
    String folder = "force " + directory.getFileName();
    assertThat(disk.steps.subList(0, 7))
        .containsExactly(
            "force",
            ".a.film.tmp to a.film",
            folder,
            "force",
            "a.film to a.film.bak",
            ".a.film.tmp to a.film",
            folder);
  }

  @Test
  void reservedPlaceIsFreeForFilesAndForNobodyElse() throws IOException {
    Path target = directory.resolve("a.film");
    try (Closeable reservation = OutputFile.reserve(target)) {
      assertThat(reservation).isNotNull();
      assertThatThrownBy(() -> OutputFile.reserve(target))
          .hasMessage(target + ": another run is writing this file");
      try (OutputFile file = OutputFile.open(target)) {
        put(file, "content");
        file.commit();
      }
    }
    assertThat(names()).containsExactly("a.film");
    OutputFile.reserve(target).close();
  }

  /** The file gets its name even if syncing the folder fails; the next run finds the name free. */
  @Test
  void placeIsFreeAfterAFaultOfTheFolder() throws IOException {
    Path target = directory.resolve("a.png");
    Disk faulty =
        new Disk() {
          @Override
          public void forceDirectory(Path parent) {
            throw new IllegalStateException("planted");
          }
        };
    OutputFile file = OutputFile.open(target, faulty);
    assertThatThrownBy(file::commit).hasMessage("planted");
    FileChannel again = FileChannel.open(target, StandardOpenOption.WRITE);
    assertThat(again.tryLock()).isNotNull();
    again.close();
  }

  @Test
  void closingTwiceDoesNothing() throws IOException {
    Path target = directory.resolve("a.png");
    OutputFile file = OutputFile.open(target);
    assertThat(file.target()).isEqualTo(target);
    file.close();
    try (OutputFile other = OutputFile.open(target)) {
      file.close();
      put(other, "new");
      other.commit();
    }
    assertThat(target).hasContent("new");
  }

  @Test
  void refusalNamesTheReasonOfTheFileSystem() throws IOException {
    Files.createDirectory(directory.resolve(".a.png.tmp"));
    assertThatThrownBy(() -> OutputFile.open(directory.resolve("a.png")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("cannot be written: is a directory");
  }

  /** The file of a second name would be emptied. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void hardLinksAtTheTemporaryNameAreRefused() throws IOException {
    Path other = Files.writeString(directory.resolve("other.txt"), "other");
    Files.createLink(directory.resolve(".a.png.tmp"), other);
    assertThatThrownBy(() -> OutputFile.open(directory.resolve("a.png")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(".a.png.tmp, found a hard link; remove it");
    assertThat(other).hasContent("other");
  }
}
