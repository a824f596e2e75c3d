package io.github.lumbre.cli.option;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flag for a viewer of previews. */
public final class DisplayServerFlag {
  private static final Pattern ADDRESS =
      Pattern.compile("(\\[[0-9a-fA-F:.]+\\]|[^\\s:]+):(\\d{1,5})");

  @Spec(Spec.Target.MIXEE)
  CommandSpec spec;

  @Option(
      names = "--display-server",
      paramLabel = "HOST:PORT",
      description =
          "Show the picture and its layers, as they converge, in an image viewer that speaks tev's"
              + " protocol (tev and HDRView listen at port 14158).")
  Optional<String> server;

  /**
   * Returns the address of the viewer, not looked up yet; empty without the flag.
   *
   * @throws ParameterException if it is malformed
   */
  public Optional<InetSocketAddress> address() {
    return server.map(this::parsed);
  }

  private InetSocketAddress parsed(String text) {
    Matcher matcher = ADDRESS.matcher(text);
    int port = matcher.matches() ? Integer.parseInt(matcher.group(2)) : 0;
    if (port < 1 || port > 65535) {
      throw new ParameterException(
          spec.commandLine(),
          "--display-server: expected HOST:PORT, such as localhost:14158, found " + text);
    }
    return InetSocketAddress.createUnresolved(matcher.group(1), port);
  }
}
