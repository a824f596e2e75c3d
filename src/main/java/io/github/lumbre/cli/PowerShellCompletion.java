package io.github.lumbre.cli;

import io.github.lumbre.cli.Completion.Flag;
import io.github.lumbre.cli.Completion.Kind;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The script that completes commands, flags and values of flags in PowerShell, which completes file
 * names itself where there is no answer.
 */
final class PowerShellCompletion {
  private static final String SCRIPT =
      """
      # Completion for lumbre in PowerShell:
      # lumbre completion --shell powershell | Out-String | Invoke-Expression
      Register-ArgumentCompleter -Native -CommandName lumbre, lumbre.cmd -ScriptBlock {
        param($word, $line, $position)
        $commands = @{
      COMMANDS  }
        $words = @($line.CommandElements | Select-Object -Skip 1 | ForEach-Object { $_.ToString() })
        if ($word) {
          $words = @($words | Select-Object -SkipLast 1)
        }
        $name = ''
        if ($words.Count -gt 0 -and $commands.ContainsKey($words[0])) {
          $name = $words[0]
        }
        $command = $commands[$name]
        $flag = ''
        if ($words.Count -gt 0) {
          $flag = $words[-1]
        }
        $before = ''
        if ($command.values.ContainsKey($flag)) {
          $found = $command.values[$flag]
          if ($command.lists -contains $flag -and $word -match '^(.*,)') {
            $before = $Matches[1]
          }
        } elseif ("$word".StartsWith('-')) {
          $found = $command.flags
        } else {
          $found = $command.words
        }
        $found = $found | ForEach-Object { $before + $_ } | Where-Object { $_ -like "$word*" }
        $found | ForEach-Object {
          [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
        }
      }
      """;

  private PowerShellCompletion() {}

  static String of(List<Completion> commands) {
    StringBuilder table = new StringBuilder();
    for (Completion command : commands) {
      List<String> flags = command.flags().stream().flatMap(f -> f.names().stream()).toList();
      table.append("    '").append(command.name()).append("' = @{\n");
      table.append("      words = ").append(array(command.words())).append("\n");
      table.append("      flags = ").append(array(flags)).append("\n");
      table.append("      lists = ").append(array(lists(command))).append("\n");
      table.append("      values = @{\n");
      for (Flag flag : command.flags()) {
        if (flag.kind() != Kind.NONE) {
          for (String name : flag.names()) {
            table.append("        '").append(name).append("' = ");
            table.append(array(flag.words())).append("\n");
          }
        }
      }
      table.append("      }\n    }\n");
    }
    return SCRIPT.replace("COMMANDS", table);
  }

  private static List<String> lists(Completion command) {
    return command.flags().stream()
        .filter(flag -> flag.kind() == Kind.LIST)
        .flatMap(flag -> flag.names().stream())
        .toList();
  }

  private static String array(List<String> words) {
    return words.stream()
        .map(word -> "'" + word + "'")
        .collect(Collectors.joining(", ", "@(", ")"));
  }
}
