package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Method;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Commands that measure nothing start without the classes of the lab, and help lists all. */
class WithoutLabTest {
  private static final String LAB = "io.github.lumbre.lab.";

  @TempDir private Path folder;

  /** Loads the program again, without the lab. */
  private static final class ProgramLoader extends URLClassLoader {
    ProgramLoader() {
      super(
          Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
              .map(ProgramLoader::url)
              .toArray(URL[]::new),
          getPlatformClassLoader());
    }

    private static URL url(String path) {
      try {
        return Path.of(path).toUri().toURL();
      } catch (MalformedURLException e) {
        throw new AssertionError(e);
      }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
      if (name.startsWith(LAB)) {
        throw new ClassNotFoundException(name);
      }
      return super.findClass(name);
    }
  }

  private Outcome run(String line) throws IOException, ReflectiveOperationException {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    try (ProgramLoader loader = new ProgramLoader()) {
      Method run =
          loader
              .loadClass(Lumbre.class.getName())
              .getDeclaredMethod("run", String[].class, PrintWriter.class, PrintWriter.class);
      run.setAccessible(true);
      String[] args = line.replace("FOLDER", folder.toString()).split(" ");
      int code = (int) run.invoke(null, args, new PrintWriter(out), new PrintWriter(err));
      return new Outcome(code, out.toString(), err.toString());
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--help",
        "help trade",
        "help selftest",
        "completion",
        "check scenes/cornell-box.json",
        "audit scenes/cornell-box.json",
        "pixel scenes/cornell-box.json 9,9 --size 16 -s 1",
        "render scenes/cornell-box.json -o FOLDER/a.png --size 16 -s 1",
        "views scenes/models/lantern.glb -o FOLDER --size 16 -s 1"
      })
  void commandsStart(String line) throws IOException, ReflectiveOperationException {
    Outcome outcome = run(line).done();
  }

  @Test
  void measuringNeedsTheLab() throws IOException, ReflectiveOperationException {
    assertThat(run("selftest").err()).contains("NoClassDefFoundError");
  }
}
