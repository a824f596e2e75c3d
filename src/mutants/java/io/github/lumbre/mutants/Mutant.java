package io.github.lumbre.mutants;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A defect to be planted, as a file describes it:
 *
 * <pre>
 * What is wrong, in a sentence or more.
 * tests: integrator.LightTransportTest#coincidentLightsAddUp, light.LightSamplerTest
 *
 * file: material/Lambertian.java
 *   context, which stays
 * - lines that go
 * + lines that come
 * </pre>
 *
 * The first column tells what becomes of a line, and the line itself follows at once. Empty lines
 * part the changes of one file.
 *
 * @param name of the file without its ending
 * @param tests at least one of which must fail: classes below the root package, or methods of them
 */
record Mutant(String name, String description, List<String> tests, List<Edit> edits) {
  static final String ENDING = ".mutant";
  private static final String TESTS = "tests: ";
  private static final String FILE = "file: ";

  Mutant {
    tests = List.copyOf(tests);
    edits = List.copyOf(edits);
  }

  /**
   * Reads the description of a defect.
   *
   * @throws MutantException if it is not of the form above
   */
  static Mutant read(Path path) throws IOException, MutantException {
    String fileName = path.getFileName().toString();
    String name = fileName.substring(0, fileName.length() - ENDING.length());
    List<String> lines = new ArrayList<>(Files.readAllLines(path));
    List<String> description = new ArrayList<>();
    while (!lines.isEmpty() && !lines.get(0).startsWith(TESTS)) {
      description.add(lines.remove(0));
    }
    if (lines.isEmpty() || description.isEmpty()) {
      throw new MutantException("expected a description and a line of \"" + TESTS + "\"");
    }
    List<String> tests = List.of(lines.remove(0).substring(TESTS.length()).split(", *"));
    List<Edit> edits = edits(lines);
    if (edits.isEmpty()) {
      throw new MutantException("expected a change, found none");
    }
    return new Mutant(name, String.join(" ", description), tests, edits);
  }

  private static List<Edit> edits(List<String> lines) throws MutantException {
    List<Edit> edits = new ArrayList<>();
    List<String> before = new ArrayList<>();
    List<String> after = new ArrayList<>();
    String file = "";
    lines.add("");
    for (String line : lines) {
      if (line.isEmpty() || line.startsWith(FILE)) {
        if (!before.isEmpty()) {
          edits.add(new Edit(file, before, after));
        }
        before.clear();
        after.clear();
        file = line.isEmpty() ? file : line.substring(FILE.length());
        continue;
      }
      String rest = line.substring(1);
      switch (line.charAt(0)) {
        case ' ' -> {
          before.add(rest);
          after.add(rest);
        }
        case '-' -> before.add(rest);
        case '+' -> after.add(rest);
        default -> throw new MutantException("expected ' ', '-' or '+' first, found: " + line);
      }
    }
    return edits;
  }
}
