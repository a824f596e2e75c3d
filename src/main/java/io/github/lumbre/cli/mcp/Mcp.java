package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.limit.Limits;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/** The tools for models as a server. Stateless. */
public final class Mcp {
  /** The time of a call, for slow machines; clients cancel calls that are too long for them. */
  private static final Duration MOST_TIME = Duration.ofMinutes(2);

  private Mcp() {}

  /**
   * Serves one client until its messages end.
   *
   * @param roots folders that exist; calls may read files in them and below
   * @throws IOException if the messages or a folder cannot be read
   */
  public static void serve(List<Path> roots, InputStream in, OutputStream out) throws IOException {
    Roots confined = new Roots(roots);
    Limits limits = Limits.UPLOADS;
    Studio studio = new Studio(confined, limits);
    List<Tool> tools =
        List.of(
            new ViewsTool(studio),
            new RenderTool(studio, false),
            new RenderTool(studio, true),
            new DescribeTool(studio),
            new PixelTool(studio),
            new DiffTool(studio),
            new CompareTool(confined, limits));
    WarmUp warmUp = WarmUp.start();
    new McpServer(in, new Answers(out), tools, MOST_TIME).beforeCalls(warmUp::end).serve();
  }
}
