package io.github.lumbre.model.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.base.file.ExternalProgram;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests programs that convert models, with small scripts. Each notes where it shall write; that
 * folder must not remain.
 */
@DisabledOnOs(OS.WINDOWS)
class ImportProgramTest {
  private static final String GLB = "printf 'glTF and more' > \"$2\"\n";
  private static final Duration LONG = Duration.ofMinutes(2);

  @TempDir private Path folder;
  private Path source;

  @BeforeEach
  void writeSource() throws IOException {
    source = Files.writeString(folder.toRealPath().resolve("a b;$HOME.fbx"), "a model");
  }

  private ImportProgram program(String script) throws IOException {
    String noted = "#!/bin/sh\necho \"$2\" > \"$1.out\"\n" + script;
    Path file = Files.writeString(folder.resolve("tool"), noted);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    return ImportProgram.of(file + " {in} {out}", Map.of());
  }

  private String noted(String ending) throws IOException {
    return Files.readString(Path.of(source + ending)).strip();
  }

  private void assertNothingLeft() throws IOException {
    assertThat(source).hasContent("a model");
    Path out = Path.of(noted(".out"));
    assertThat(out).isAbsolute();
    assertThat(out.getParent()).doesNotExist();
  }

  private void assertFails(ImportProgram program, String message) throws IOException {
    assertThatThrownBy(() -> program.run(source))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(folder.resolve("tool") + ": ")
        .hasMessageContaining(message);
    assertNothingLeft();
  }

  private static void assertEnds(String process) throws Exception {
    Optional<ProcessHandle> handle = ProcessHandle.of(Long.parseLong(process));
    if (handle.isPresent()) {
      handle.get().onExit().get(30, TimeUnit.SECONDS);
    }
  }

  @Test
  void programsStartInTheFolderOfTheModelWithoutInput() throws Exception {
    ImportProgram program = program("pwd > \"$1.pwd\"; wc -c > \"$1.in\"\n" + GLB);
    assertThat(program.run(source).glb()).asString().isEqualTo("glTF and more");
    assertThat(noted(".pwd")).isEqualTo(source.getParent().toString());
    assertThat(noted(".in").strip()).isEqualTo("0");
    assertNothingLeft();
  }

  @Test
  void wordsOfTemplatesAreArguments() throws Exception {
    Path tool = folder.resolve("tool");
    program("");
    Files.writeString(tool, "#!/bin/sh\necho \"$1|$2|$3|$4\" > \"$3.words\"\nprintf glTF > \"$4\"\n");
    ImportProgram.of(tool + "  -x  $HOME;ls {in} {out}", Map.of()).run(source);
    assertThat(noted(".words")).startsWith("-x|$HOME;ls|" + source + "|/");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "exit 0 | left no GLB: no file",
        "echo so; echo why >&2; exit 1 | failed with code 1: so; why",
        "ln -s /etc/passwd \"$2\" | left no GLB: a link or another special file",
        "mkfifo \"$2\" | left no GLB: a link or another special file",
        "mkdir \"$2\" | left no GLB: a link or another special file",
        ": > \"$2\" | left no GLB: an empty file",
        "echo hello > \"$2\" | left no GLB: another kind of file",
        "cp \"$0\" \"$2\" | left no GLB",
        "printf '; FBX' > \"$2\" | left no GLB: FBX",
        "printf glTF > \"$2.glb\" | left no GLB: no file",
        "kill -9 $$ | failed with code"
      })
  void programsThatFailAreNamedWithTheCause(String script, String message) throws IOException {
    assertFails(program(script + "\n").within(LONG, 1 << 20), message);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "sleep 3600",
        "trap '' TERM INT; while :; do sleep 1; done",
        "while :; do echo flood; done",
        "sleep 3600 & wait"
      })
  void programsThatHangAreEnded(String script) throws IOException {
    ImportProgram program = program(script + "\n").within(Duration.ofMillis(700), 1 << 20);
    assertThatThrownBy(() -> program.run(source))
        .isInstanceOf(ExternalProgram.LimitException.class)
        .hasMessageEndingWith("took longer than 0.7 s and was ended");
    assertNothingLeft();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "exec cat /dev/zero > \"$2\"",
        "exec cat /dev/zero > \"$TMPDIR/other\"",
        "head -c 2000000 /dev/zero > \"$2\"; sleep 3600",
        "head -c 2000000 /dev/zero > \"$2\"",
        "mkdir \"$TMPDIR/sub\"; head -c 2000000 /dev/zero > \"$TMPDIR/sub/other\"; sleep 3600"
      })
  void programsThatWriteTooMuchAreEnded(String script) throws IOException {
    ImportProgram program = program(script + "\n").within(LONG, 1 << 20);
    long start = System.nanoTime();
    assertThatThrownBy(() -> program.run(source))
        .isInstanceOf(ExternalProgram.LimitException.class)
        .hasMessageEndingWith("wrote more than 1048576 bytes and was ended");
    assertThat(System.nanoTime() - start).isLessThan(60_000_000_000L);
    assertNothingLeft();
  }

  @Test
  void talkativeProgramsAreDrained() throws Exception {
    ImportProgram program = program("head -c 5000000 /dev/zero | tr '\\0' x\n" + GLB);
    assertThat(program.run(source).glb()).hasSize(13);
  }

  /** The parents of these children have ended when the program ends. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "sleep 3600 & echo $! > \"$1.pid\"",
        "(sleep 3600 > /dev/null 2>&1 & echo $! > \"$1.pid\")",
        "nohup sh -c 'echo $$ > \"$0.pid\"; exec sleep 3600' \"$1\" > /dev/null 2>&1 &\nsleep 0.5"
      })
  void childrenThatLiveOnAreEnded(String script) throws Exception {
    assertThat(program(script + "\n" + GLB).run(source).glb()).hasSize(13);
    assertEnds(noted(".pid"));
    assertNothingLeft();
  }

  @Test
  void anInterruptEndsTheProgram() throws Exception {
    ImportProgram program = program("echo $$ > \"$1.pid\"; exec sleep 3600\n");
    Thread thread = Thread.currentThread();
    Thread interrupter =
        new Thread(
            () -> {
              while (!Files.exists(Path.of(source + ".pid"))) {
                Thread.onSpinWait();
              }
              thread.interrupt();
            });
    interrupter.start();
    assertThatThrownBy(() -> program.run(source)).isInstanceOf(InterruptedException.class);
    interrupter.join();
    assertEnds(noted(".pid"));
    assertNothingLeft();
  }

  @Test
  void theIdentityIsThatOfTheSourceAndTheTemplate() throws Exception {
    byte[] first = program("date +%N >> \"$1.x\"\n" + GLB).run(source).identity();
    assertThat(program("printf 'glTF2' > \"$2\"\n").run(source).identity()).isEqualTo(first);
    Path tool = folder.resolve("tool");
    ImportProgram other = ImportProgram.of(tool + " {in} {out} -x", Map.of());
    assertThat(other.run(source).identity()).isNotEqualTo(first);
    Files.writeString(source, "another model");
    assertThat(program(GLB).run(source).identity()).isNotEqualTo(first);
  }

  @Test
  void wrongTemplatesAreRefused() throws IOException {
    program("");
    Path tool = folder.resolve("tool");
    for (String text :
        List.of(
            tool + " {in}",
            tool + " {out}",
            tool + " {in} {in} {out}",
            tool + " --in={in} {out}",
            tool + " '{in}' {out}",
            "tool {in} {out}",
            "./tool {in} {out}",
            "/no/such/tool {in} {out}",
            folder + " {in} {out}",
            source + ";x {in} {out}",
            "nothing",
            "assimp=",
            "step= ",
            "Assimp",
            "",
            " ")) {
      assertThatThrownBy(() -> ImportProgram.of(text, Map.of()))
          .as(text)
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("expected");
    }
  }

  @Test
  void knownProgramsAreFoundAsOthers() throws Exception {
    Path tool = folder.resolve("assimp");
    assertThatThrownBy(() -> ImportProgram.of("assimp", Map.of("PATH", "/nowhere")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("assimp: not found on the PATH")
        .hasMessageContaining("LUMBRE_ASSIMP");
    Files.writeString(tool, "#!/bin/sh\necho \"$*\" > \"$2.words\"\nprintf glTF > \"$3\"\n");
    Files.setPosixFilePermissions(tool, PosixFilePermissions.fromString("rwxr-xr-x"));
    for (ImportProgram program :
        List.of(
            ImportProgram.of("assimp", Map.of("PATH", folder.toString())),
            ImportProgram.of("assimp", Map.of("LUMBRE_ASSIMP", tool.toString())),
            ImportProgram.of("assimp=" + tool, Map.of("PATH", "/nowhere")))) {
      assertThat(program.run(source).glb()).asString().isEqualTo("glTF");
      assertThat(noted(".words")).startsWith("export " + source + " /").endsWith("-fglb2 -embtex");
    }
    // In some locales, names of folders cannot be expressed.
    for (String path : List.of(folder.toString(), "/no\0path" + File.pathSeparator + folder)) {
      assertThat(ImportProgram.suiting("a.FBX", Map.of("PATH", path))).containsExactly("assimp");
    }
    assertThat(ImportProgram.suiting("a.fbx", Map.of("LUMBRE_ASSIMP", "/no\0path"))).isEmpty();
    assertThat(ImportProgram.suiting("a.fbx", Map.of("PATH", "/nowhere"))).isEmpty();
    assertThat(ImportProgram.suiting("a.txt", Map.of("PATH", folder.toString()))).isEmpty();
  }

  @Test
  void scriptsOfKnownProgramsAreWrittenForThem() throws Exception {
    Path python = folder.resolve("python3");
    Files.writeString(python, "#!/bin/sh\ncat \"$1\" > \"$2.script\"\nprintf glTF > \"$3\"\n");
    Files.setPosixFilePermissions(python, PosixFilePermissions.fromString("rwxr-xr-x"));
    ImportProgram.of("step", Map.of("PATH", folder.toString())).run(source);
    assertThat(noted(".script")).contains("STEPCAFControl_Reader").contains("Zup");
    Path blender = folder.resolve("blender");
    Files.writeString(
        blender,
        "#!/bin/sh\nwhile [ \"$1\" != -- ]; do last=$1; shift; done\n"
            + "cat \"$last\" > \"$2.script\"\nprintf glTF > \"$3\"\n");
    Files.setPosixFilePermissions(blender, PosixFilePermissions.fromString("rwxr-xr-x"));
    ImportProgram.of("blender=" + blender, Map.of()).run(source);
    assertThat(noted(".script")).contains("export_scene.gltf");
    assertThat(new String(Files.readAllBytes(source), StandardCharsets.UTF_8)).isEqualTo("a model");
  }

  private static void assumePython() {
    assumeTrue(
        Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
            .anyMatch(each -> Files.isExecutable(Path.of(each, "python3"))));
  }

  /** A Python with a stand-in of Blender's module, whose importer adds objects in some order. */
  @Test
  void theScriptForBlenderOrdersWhatImportersLeave() throws Exception {
    assumePython();
    Files.writeString(
        folder.resolve("bpy.py"),
        """
        import types
        class Objects(list):
            unlink = list.remove
            link = list.append
        def collected(names):
            objects = Objects(types.SimpleNamespace(name=name) for name in names)
            return types.SimpleNamespace(objects=objects)
        class Importer:
            def get_rna_type(self):
                pass
            def __call__(self, filepath):
                context.scene.collection = collected("cab")
                data.collections.append(collected("yzx"))
        def export(filepath, **options):
            every = [context.scene.collection, *data.collections]
            names = [each.name for collection in every for each in collection.objects]
            open(filepath, "w").write("glTF" + "".join(names))
        context = types.SimpleNamespace(scene=types.SimpleNamespace(collection=collected("")))
        data = types.SimpleNamespace(objects=Objects(), collections=[])
        ops = types.SimpleNamespace(
            wm=types.SimpleNamespace(fbx_import=Importer()),
            export_scene=types.SimpleNamespace(gltf=export))
        """);
    Path blender = folder.resolve("blender");
    Files.writeString(
        blender,
        "#!/bin/sh\nwhile [ \"$2\" != -- ]; do shift; done\n"
            + "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=. exec python3 \"$@\"\n");
    Files.setPosixFilePermissions(blender, PosixFilePermissions.fromString("rwxr-xr-x"));
    ImportProgram program = ImportProgram.of("blender=" + blender, Map.of());
    assertThat(program.run(source).glb()).asString().isEqualTo("glTFabcxyz");
  }

  /** A Python without packages of its own. */
  @Test
  void theScriptForStepSaysWhatToInstall() throws Exception {
    assumePython();
    Path python = folder.resolve("python3");
    Files.writeString(
        python,
        "#!/bin/sh\necho \"$3\" > \"$2.out\"\nexec /usr/bin/env python3 -I -S \"$@\"\n");
    Files.setPosixFilePermissions(python, PosixFilePermissions.fromString("rwxr-xr-x"));
    assertThatThrownBy(() -> ImportProgram.of("step=" + python, Map.of()).run(source))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("failed with code 1: needs the package cadquery-ocp")
        .hasMessageContaining("-m pip install cadquery-ocp");
    assertNothingLeft();
  }
}
