package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputFileTest {
  @TempDir Path directory;

  private static void put(OutputFile file, String text) throws IOException {
    file.restart().write(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
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
  void aMissingDirectoryIsNamed() {
    Path target = directory.resolve("no").resolve("a.png");
    assertThatThrownBy(() -> OutputFile.open(target))
        .isInstanceOf(IOException.class)
        .hasMessage(target + ": the directory " + target.getParent() + " does not exist");
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
    // Nobody, not even the superuser, can create files there.
    Path target = Path.of("/proc/self/a.png");
    assumeTrue(Files.isDirectory(target.getParent()));
    assertThatThrownBy(() -> OutputFile.open(target))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("/proc/self/a.png: the directory /proc/self cannot be written: ");
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
}
