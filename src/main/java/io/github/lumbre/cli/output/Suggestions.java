package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.model.Models;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Suggests what a user may have meant by an unknown flag or command.
 *
 * @param commands names of all commands
 * @param program the program with all commands, whose flags are searched
 */
public record Suggestions(Collection<String> commands, Supplier<CommandLine> program) {
  /** Names of files that 'lumbre view' shows, in lower case. */
  private static final Pattern SEEN = Pattern.compile(".*[.](film|exr|png|jpe?g|hdr|pfm)");

  /** Flags, with a value where they need one, by their names in other programs. */
  private static final Map<String, String> FLAGS = new LinkedHashMap<>();

  /** Commands by their names in other programs. */
  private static final Map<String, String> COMMANDS = new LinkedHashMap<>();

  static {
    flag("--samples N", "spp samplesperpixel samplecount numsamples passes aa");
    flag("--size WxH", "width height w resolution res dimensions imagesize side");
    flag("--sky FILE", "hdri hdr env envmap environment environmentmap ibl skybox dome");
    flag("--background transparent", "transparent transparency transparentbackground alpha");
    flag("--background COLOR", "bg bgcolor backgroundcolor backcolor clearcolor");
    flag("--output OUT", "out outfile outputfile outputpath dest destination");
    flag("--fps N", "framerate rate");
    flag("--view AZ,EL", "angle azimuth elevation orbit cameraangle cameraorbit direction front");
    flag("--fov DEGREES", "fieldofview yfov anglefov");
    flag("--turntable N", "spin rotate orbitframes");
    flag("--animation NAME", "anim clip");
    flag("--ground", "floor shadow shadows groundplane");
    flag("--look lines", "wireframe edges outline lineart");
    flag("--look clay", "clay flat matcap");
    flag("--section PLANE", "cut slice crosssection clipplane");
    flag("--depth N", "bounces maxbounces maxdepth raydepth");
    flag("--tonemap NAME", "tonemapping tonemapper viewtransform");
    flag("--exposure EV", "ev stops brightness");
    flag("--layers NAMES", "aov aovs");
    flag("--threads N", "jobs cores cpus workers j");
    flag("--overwrite", "force yes clobber");
    flag("--quiet", "silent q");
    flag("--stats", "verbose v");
    flag("--up z", "zup upaxis");
    flag("--unit LENGTH", "units");
    flag("--crop x,y,w,h", "region window");
    flag("-o drawing.svg", "svg vector vectors");
    flag("--hidden dashed", "hidden-lines dashed dashes hlr");
    flag("--labels LIST", "annotate annotations axes");
    flag("--no-denoise", "nodenoising raw");
    flag("--variant NAME", "materialvariant");
    command("check", "info inspect stat stats list ls describe validate verify lint");
    command("render", "convert thumbnail thumb snapshot screenshot draw image picture");
    command("view", "show open serve preview watch gui");
    command("merge", "combine join");
    command("resume", "continue restart");
    command("render --turntable 36", "turntable spin");
    command("render --animation NAME", "animate animation");
    command("render --section PLANE", "section");
    command("perf", "profile time");
  }

  private static void flag(String here, String others) {
    List.of(others.split(" ")).forEach(other -> FLAGS.put(other, here));
  }

  private static void command(String here, String others) {
    List.of(others.split(" ")).forEach(other -> COMMANDS.put(other, here));
  }

  /** Returns flags, with a value where they need one, by their names in other programs. */
  public static Map<String, String> knownFlags() {
    return Map.copyOf(FLAGS);
  }

  /** Returns commands by their names in other programs. */
  public static Map<String, String> knownCommands() {
    return Map.copyOf(COMMANDS);
  }

  /** Returns what may be meant by an unknown flag of a command, after a semicolon; or nothing. */
  String forFlag(String flag, CommandSpec command) {
    String name = bare(flag);
    String key = name.replace("-", "").toLowerCase(Locale.ROOT);
    Optional<String> known = Optional.ofNullable(FLAGS.get(key));
    String meant = known.map(text -> text.split(" ")[0]).orElse("--" + name);
    if (command.optionsMap().containsKey(meant)) {
      return didYouMean(known.orElse(meant));
    }
    List<String> others = othersWith(meant);
    if (!others.isEmpty()) {
      return "; " + meant + " is a flag of " + String.join(", ", others);
    }
    Map<String, String> own = longFlags(command);
    return Optional.of(name)
        .filter(text -> text.length() > 1)
        .flatMap(text -> Spelling.similar(text, own.keySet()))
        .map(own::get)
        .map(Suggestions::didYouMean)
        .orElse("");
  }

  /** Returns commands that have a flag, the first three. */
  private List<String> othersWith(String flag) {
    List<String> others = new ArrayList<>();
    program
        .get()
        .getSubcommands()
        .forEach(
            (known, other) -> {
              boolean hasIt = other.getCommandSpec().optionsMap().containsKey(flag);
              if (hasIt && others.size() < 3) {
                others.add("'lumbre " + known + "'");
              }
            });
    return others;
  }

  /** Returns the flags of more than one letter of a command by their names without dashes. */
  private static Map<String, String> longFlags(CommandSpec command) {
    Map<String, String> all = new LinkedHashMap<>();
    command.optionsMap().keySet().stream()
        .filter(flag -> flag.startsWith("--"))
        .forEach(flag -> all.put(bare(flag), flag));
    return all;
  }

  private static String bare(String flag) {
    return flag.replaceFirst("=.*", "").replaceFirst("^--?", "");
  }

  /** Returns what may be meant by an unknown command, after a semicolon; or nothing. */
  String forCommand(String found) {
    String name = found.toLowerCase(Locale.ROOT);
    if (Models.isModelName(found) || name.endsWith(".json")) {
      return didYouMean("'lumbre render " + found + "'");
    }
    if (SEEN.matcher(name).matches()) {
      return didYouMean("'lumbre view " + found + "'");
    }
    return Optional.ofNullable(COMMANDS.get(name))
        .or(() -> Spelling.similar(found, commands))
        .map(Suggestions::didYouMean)
        .orElse("");
  }

  private static String didYouMean(String text) {
    return "; did you mean " + text + "?";
  }
}
