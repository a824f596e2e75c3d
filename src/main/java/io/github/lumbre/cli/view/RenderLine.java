package io.github.lumbre.cli.view;

import io.github.lumbre.cli.output.ShellText;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.MovedCamera;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The command line that renders what a page shows. Immutable.
 *
 * @param scene path of the scene or model
 * @param flags of the command
 */
public record RenderLine(Path scene, List<Flag> flags) {
  private static final String SAMPLES = "--samples";
  private static final String SIZE = "--size";

  /**
   * A flag.
   *
   * @param name its longest one
   * @param words as they were given
   */
  public record Flag(String name, List<String> words) {
    public Flag {
      words = List.copyOf(words);
    }
  }

  public RenderLine {
    flags = List.copyOf(flags);
  }

  /**
   * Returns the line with the flags of another command that rendering knows, too.
   *
   * @param args of the other command, which are valid
   */
  public static RenderLine of(Path scene, List<String> args, CommandSpec other, CommandSpec render) {
    List<Flag> flags = new ArrayList<>();
    for (int i = 0; i < args.size(); i++) {
      String word = args.get(i);
      Optional<OptionSpec> option = option(word, other);
      if (option.isPresent()) {
        boolean isWhole = option.get().arity().max() == 0 || !isName(word, option.get());
        List<String> words = isWhole ? List.of(word) : List.of(word, args.get(++i));
        if (render.findOption(option.get().longestName()) != null) {
          flags.add(new Flag(option.get().longestName(), words));
        }
      }
    }
    return new RenderLine(scene, flags);
  }

  private static boolean isName(String word, OptionSpec option) {
    return List.of(option.names()).contains(word);
  }

  /** Returns the option that a word names; empty if it is none. */
  private static Optional<OptionSpec> option(String word, CommandSpec command) {
    String name = word.startsWith("--") ? word.split("=", 2)[0] : word;
    return Stream.of(name, word.substring(0, Math.min(2, word.length())))
        .filter(each -> each.startsWith("-"))
        .map(command::findOption)
        .filter(found -> found != null)
        .findFirst();
  }

  /**
   * Returns the line for a camera that was moved before a model.
   *
   * @param camera the flags that place it
   */
  public RenderLine movedTo(List<String> camera, RenderSettings settings) {
    List<String> replaced = MovedCamera.REPLACED.stream().map(ModelOption::flag).toList();
    List<Flag> all =
        new ArrayList<>(flags.stream().filter(flag -> !replaced.contains(flag.name())).toList());
    boolean isUsual =
        settings.width() == Stage.DEFAULT_WIDTH && settings.height() == Stage.DEFAULT_HEIGHT;
    if (!isUsual && !has(SIZE)) {
      all.add(new Flag(SIZE, List.of(SIZE, settings.width() + "x" + settings.height())));
    }
    camera.forEach(flag -> all.add(new Flag(flag.split("=", 2)[0], List.of(flag))));
    return new RenderLine(scene, all);
  }

  private boolean has(String name) {
    return flags.stream().anyMatch(flag -> flag.name().equals(name));
  }

  /** Returns the line for a shell, with the samples of the page. */
  public String text(RenderSettings settings) {
    List<String> words = new ArrayList<>(List.of("lumbre", "render", scene.toString()));
    flags.forEach(flag -> words.addAll(flag.words()));
    if (!has(SAMPLES) && settings.samples() < RenderSettings.MAX_SAMPLES) {
      words.addAll(List.of("-s", String.valueOf(settings.samples())));
    }
    words.addAll(List.of("-o", picture()));
    return words.stream().map(ShellText::quoted).collect(Collectors.joining(" "));
  }

  private String picture() {
    return String.valueOf(scene.getFileName()).replaceFirst("[.][^.]*$", "") + ".png";
  }
}
