package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.option.BudgetFlags;
import io.github.lumbre.cli.option.FlagConverters;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.StandardOutput;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.Interruption;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.lang.reflect.Constructor;
import java.lang.reflect.InaccessibleObjectException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/**
 * The program: runs the command that the arguments name and exits with an {@link ExitCode}.
 */
@Command(
    name = "lumbre",
    header = "Lumbre, a CPU path tracer: renders scenes and 3D models to pictures.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    synopsisSubcommandLabel = "COMMAND",
    footer = {
      "",
      "Examples:",
      "  lumbre render scenes/cornell-box.json",
      "  lumbre render helmet.glb --view iso",
      "  lumbre render scene.json -o picture.exr --samples 1000 --size 1280x720",
      "  lumbre view helmet.glb",
      "  lumbre resume night.film",
      "  lumbre check scene.json",
      "  lumbre audit scene.json",
      "  lumbre pixel scene.json 120,80",
      "  lumbre benchmark --rows 1,5,14",
      "  lumbre perf scenes/cornell-box.json",
      "  lumbre compare draft.exr reference.exr",
      "  lumbre render --help"
    })
public final class Lumbre implements Runnable {
  /** The character that Java substitutes for bytes that are invalid in the locale's encoding. */
  private static final char GARBLED = '\ufffd';

  /**
   * The types of picocli's own converters that no flag uses and that take a while to load: regular
   * expressions, simple ones because picocli compiles them for each type.
   */
  static final String EXCLUDED_CONVERTERS = "java.sql.*,java.time.*";

  /** The commands under the headings of the help, in its order. */
  static final Map<String, List<Class<?>>> SECTIONS = new LinkedHashMap<>();

  /** The commands by name, in the same order. */
  private static final Map<String, Class<?>> COMMANDS = new LinkedHashMap<>();

  static {
    SECTIONS.put(
        "Make pictures",
        List.of(
            RenderCommand.class,
            ViewCommand.class,
            ResumeCommand.class,
            MergeCommand.class,
            DevelopCommand.class,
            DenoiseCommand.class,
            ViewsCommand.class,
            McpCommand.class,
            ImportCommand.class));
    SECTIONS.put(
        "Understand a scene",
        List.of(CheckCommand.class, AuditCommand.class, PixelCommand.class, LayersCommand.class));
    SECTIONS.put(
        "Measure",
        List.of(
            CompareCommand.class,
            DiffCommand.class,
            TradeCommand.class,
            PerfCommand.class,
            CoverageCommand.class,
            SelfTestCommand.class));
    SECTIONS.put("The 2016 report", List.of(BenchmarkCommand.class));
    SECTIONS.put("Other", List.of(CompletionCommand.class, ManCommand.class, HelpCommand.class));
    SECTIONS.values().stream()
        .flatMap(List::stream)
        .forEach(command -> COMMANDS.put(nameOf(command), command));
  }

  /** Current commands by their names before 0.2; these names will be removed in 0.3. */
  private static final Map<String, String> RENAMED = Map.of("bench", "perf");

  @Option(
      names = "--debug",
      scope = ScopeType.INHERIT,
      description = "Print the stack trace of an error.")
  private boolean debug;

  @Spec private CommandSpec spec;

  /** Runs the command that the arguments name and exits. */
  public static void main(String[] args) {
    if (LabJar.runs(args)) {
      return;
    }
    // The digits of numbers are 0 to 9, also in the names of files.
    Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
    redirectErrors();
    if (!Version.isAskedForBy(args)) {
      Interruption.install();
      System.setProperty(BudgetFlags.OWN_PROCESS, "true");
      System.setProperty("picocli.converters.excludes", EXCLUDED_CONVERTERS);
    }
    Charset charset = charset(Charset.defaultCharset());
    StandardOutput results = StandardOutput.open();
    PrintWriter out = new PrintWriter(results, true, charset);
    PrintWriter err = new PrintWriter(System.err, true, charset);
    int exitCode = run(args, out, err, Engine.LOCAL);
    out.flush();
    exitCode = results.exitCode(exitCode, err);
    err.flush();
    System.exit(Interruption.exitCode(exitCode));
  }

  /** Returns the output encoding: the locale's, but UTF-8, a superset, instead of ASCII. */
  private static Charset charset(Charset fromLocale) {
    return fromLocale.equals(StandardCharsets.US_ASCII) ? StandardCharsets.UTF_8 : fromLocale;
  }

  /**
   * Prints errors to the descriptor that the launcher names. This bypasses the launcher's filter
   * for messages of the JVM. Opening {@code /dev/fd/3} would create a second file offset: if the
   * shell writes to the same file, the two would overwrite each other's output.
   */
  private static void redirectErrors() {
    Integer number = Integer.getInteger("lumbre.errors");
    if (number != null) {
      try {
        Constructor<FileDescriptor> constructor =
            FileDescriptor.class.getDeclaredConstructor(int.class);
        constructor.setAccessible(true);
        FileDescriptor descriptor = constructor.newInstance(number);
        System.setErr(new PrintStream(new FileOutputStream(descriptor), true));
      } catch (ReflectiveOperationException | InaccessibleObjectException e) {
        // This JVM does not open the class to the program, so errors pass through the filter.
      }
    }
  }

  /** Returns the name of a command: {@code render} for {@link RenderCommand}. */
  static String nameOf(Class<?> command) {
    return command.getSimpleName().replace("Command", "").toLowerCase(Locale.ROOT);
  }

  /** Returns the program with all of its commands. */
  static CommandLine commandLine() {
    return commandLine(Engine.LOCAL, COMMANDS.keySet(), false);
  }

  /** Returns the commands that arguments mention: to read the annotations of all takes a while. */
  private static Set<String> mentioned(String[] args) {
    Set<String> mentioned = new LinkedHashSet<>(COMMANDS.keySet());
    if (Collections.disjoint(List.of(args), List.of("completion", "man"))) {
      mentioned.retainAll(List.of(args));
    }
    return mentioned.isEmpty() ? Set.of("help") : mentioned;
  }

  private static CommandLine commandLine(
      Engine engine, Set<String> names, boolean isHelpForAll) {
    CommandLine.IFactory factory = factory(engine);
    CommandLine program = new CommandLine(new Lumbre(), factory);
    names.forEach(
        name -> program.addSubcommand(name, new CommandLine(COMMANDS.get(name), factory)));
    HelpLayout.applyTo(program, isHelpForAll);
    return program;
  }

  private static CommandLine.IFactory factory(Engine engine) {
    return new CommandLine.IFactory() {
      private final CommandLine.IFactory others = CommandLine.defaultFactory();

      @Override
      public <K> K create(Class<K> type) throws Exception {
        if (type == RenderCommand.class) {
          return type.cast(new RenderCommand(engine));
        }
        return type == ResumeCommand.class
            ? type.cast(new ResumeCommand(engine))
            : others.create(type);
      }
    };
  }

  /** Returns the arguments with an earlier command name replaced by the current one. */
  private static String[] renamed(String[] args, Messages messages) {
    String present = args.length == 0 ? null : RENAMED.get(args[0]);
    if (present == null) {
      return args;
    }
    messages.warning("'lumbre " + args[0] + "' is now 'lumbre " + present + "'");
    String[] current = args.clone();
    current[0] = present;
    return current;
  }

  /** Runs the command that the arguments name, and returns its exit code. */
  static int run(String[] args, PrintWriter out, PrintWriter err) {
    return run(args, out, err, Engine.LOCAL);
  }

  /**
   * Runs the command that the arguments name, and returns its exit code.
   *
   * @param engine renders the passes of {@code render} and {@code resume}
   */
  public static int run(String[] args, PrintWriter out, PrintWriter err, Engine engine) {
    if (Version.isAskedForBy(args)) {
      Version.print(out);
      return ExitCode.OK.number();
    }
    Messages messages = new Messages(err);
    String[] current = renamed(args, messages);
    boolean isHelpForAll = HelpLayout.isForAll(current);
    if (isHelpForAll) {
      current = Arrays.copyOf(current, current.length - 1);
    }
    CommandLine command = commandLine(engine, mentioned(current), isHelpForAll);
    Failures failures = new Failures(COMMANDS.keySet(), Lumbre::commandLine);
    command.setOut(out).setErr(err);
    FlagConverters.register(command);
    command.setColorScheme(CommandLine.Help.defaultColorScheme(Ansi.OFF));
    command.setParameterExceptionHandler(failures).setExecutionExceptionHandler(failures);
    command.setOverwrittenOptionsAllowed(false).setAbbreviatedOptionsAllowed(false);
    for (String arg : args) {
      if (arg.indexOf(GARBLED) >= 0) {
        messages.error(
            "%s: the locale's encoding, %s, cannot represent this argument; %s"
                .formatted(arg, System.getProperty("sun.jnu.encoding"), FileFailure.REMEDY));
        return ExitCode.USAGE.number();
      }
    }
    try {
      return command.execute(current);
    } catch (Error e) {
      ParseResult parsed = command.getParseResult();
      return Failures.report(e, command, parsed != null && Failures.isDebug(parsed)).number();
    }
  }

  /** Prints the help. */
  @Override
  public void run() {
    spec.commandLine().usage(spec.commandLine().getOut());
  }
}
