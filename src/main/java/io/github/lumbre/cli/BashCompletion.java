package io.github.lumbre.cli;

import io.github.lumbre.cli.Completion.Flag;
import io.github.lumbre.cli.Completion.Kind;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The script that completes commands, flags, values of flags and file names in bash, and in zsh
 * with its {@code bashcompinit}.
 */
final class BashCompletion {
  /** Everything but the commands. File names are what the shell completes if there is no answer. */
  private static final String SCRIPT =
      """
      # Completion for lumbre in bash and zsh: source <(lumbre completion)

      if [ -n "${ZSH_VERSION-}" ]; then
        autoload -Uz compinit bashcompinit
        type compdef >/dev/null 2>&1 || compinit
        bashcompinit
      fi

      _lumbre() {
        local word=${COMP_WORDS[COMP_CWORD]} flag=${COMP_WORDS[COMP_CWORD-1]} before=
        local command= kind=files words= flags= ends= file
        COMPREPLY=()
        if [ "$COMP_CWORD" -gt 1 ]; then
          command=${COMP_WORDS[1]}
        fi
        # bash makes three words of --flag=value, zsh one.
        if [ "$word" = '=' ]; then
          word=
        elif [ "$flag" = '=' ]; then
          flag=${COMP_WORDS[COMP_CWORD-2]}
        fi
        case $word in
          --*=*) flag=${word%%=*} before=${word%%=*}= word=${word#*=} ;;
        esac

        case $command in
      COMMANDS  esac

        case $kind:$word in
          files:-*) kind=words words=$flags ;;
          list:*) before=$before${word%"${word##*,}"} word=${word##*,} ;;
        esac
        if [ "$kind" != files ]; then
          type compopt >/dev/null 2>&1 && compopt +o default
          COMPREPLY=($(compgen -P "$before" -W "$words" -- "$word"))
        elif [ -n "$words" ]; then
          type compopt >/dev/null 2>&1 && compopt -o filenames
          COMPREPLY=($(compgen -W "$words" -- "$word"))
          local IFS=$'\\n'
          COMPREPLY+=($(compgen -f -- "$word"))
        elif [ -n "$ends" ]; then
          type compopt >/dev/null 2>&1 && compopt -o filenames
          local IFS=$'\\n'
          for file in $(compgen -f -- "$word"); do
            case " $ends " in
              *" .${file##*.} "*) COMPREPLY+=("$file") ;;
              *) [ ! -d "$file" ] || COMPREPLY+=("$file") ;;
            esac
          done
        fi
      }

      complete -o default -F _lumbre lumbre
      """;

  private BashCompletion() {}

  static String of(List<Completion> commands) {
    StringBuilder cases = new StringBuilder();
    commands.forEach(command -> append(command, cases));
    return SCRIPT.replace("COMMANDS", cases);
  }

  /** Appends the case of a command: what may stand after it and after each of its flags. */
  private static void append(Completion command, StringBuilder script) {
    script.append("    '").append(command.name()).append("')\n");
    String names =
        command.flags().stream().flatMap(f -> f.names().stream()).collect(Collectors.joining(" "));
    script.append("      flags='").append(names).append("'\n");
    String words = "words='" + String.join(" ", command.words()) + "'";
    if (!command.takesFiles()) {
      String other = "        *) kind=words " + words + " ;;\n";
      script.append("      case $word in\n        -*) ;;\n").append(other).append("      esac\n");
    } else {
      String endings = String.join(" ", command.endings());
      script.append("      ends='").append(endings).append("'\n");
    }
    Map<String, List<String>> flagsByValues = new LinkedHashMap<>();
    for (Flag flag : command.flags()) {
      if (flag.kind() != Kind.NONE) {
        flagsByValues
            .computeIfAbsent(values(flag), values -> new ArrayList<>())
            .addAll(flag.names());
      }
    }
    if (!flagsByValues.isEmpty()) {
      script.append("      case $flag in\n");
      flagsByValues.forEach(
          (values, flags) -> {
            String any = String.join(" | ", flags);
            script.append("        ").append(any).append(") ").append(values).append(" ;;\n");
          });
      script.append("      esac\n");
    }
    script.append("      ;;\n");
  }

  /** Returns the assignments that name the values of a flag. */
  private static String values(Flag flag) {
    String kind = flag.kind().name().toLowerCase(Locale.ROOT);
    return "kind=" + kind + " words='" + String.join(" ", flag.words()) + "' ends=";
  }
}
