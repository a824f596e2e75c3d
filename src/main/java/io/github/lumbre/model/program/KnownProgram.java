package io.github.lumbre.model.program;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Programs whose arguments are known. */
enum KnownProgram {
  ASSIMP(
      List.of("assimp"),
      "install it (assimp-utils)",
      "",
      List.of("export", Template.IN, Template.OUT, "-fglb2", "-embtex"),
      Set.of("fbx", "3ds", "x3d", "dae", "lwo", "ase", "ac", "x", "ms3d", "md5mesh", "b3d", "dxf")),
  BLENDER(
      List.of("blender"),
      "install it",
      "blender.py",
      List.of(
          "--background",
          "--factory-startup",
          "-noaudio",
          "--python-exit-code",
          "1",
          "--python",
          Template.SCRIPT,
          "--",
          Template.IN,
          Template.OUT),
      Set.of("blend", "usd", "usda", "usdc", "usdz", "abc", "fbx")),
  STEP(
      List.of("python3", "python"),
      "install Python and its package cadquery-ocp",
      "step.py",
      List.of(Template.SCRIPT, Template.IN, Template.OUT),
      Set.of("step", "stp"));

  /** The names of the file, the first one that is found. */
  final List<String> files;

  final String advice;

  /** The name of the script that the program runs; empty for none. */
  final String script;

  final List<String> arguments;

  /** The endings of files for which the program is the right one. */
  private final Set<String> endings;

  KnownProgram(
      List<String> files,
      String advice,
      String script,
      List<String> arguments,
      Set<String> endings) {
    this.files = files;
    this.advice = advice;
    this.script = script;
    this.arguments = arguments;
    this.endings = endings;
  }

  /** Returns the name in flags. */
  String title() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the environment variable with the path of the program. */
  String variable() {
    return "LUMBRE_" + name();
  }

  static Optional<KnownProgram> named(String name) {
    return Arrays.stream(values()).filter(each -> each.title().equals(name)).findFirst();
  }

  /** Returns the programs for a file, by the ending of its name. */
  static List<KnownProgram> suiting(String file) {
    String ending = file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    return Arrays.stream(values()).filter(each -> each.endings.contains(ending)).toList();
  }

  /** Returns the names of all programs, for messages. */
  static String names() {
    return String.join(", ", Arrays.stream(values()).map(KnownProgram::title).toList());
  }
}
