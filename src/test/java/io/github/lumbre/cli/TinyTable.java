package io.github.lumbre.cli;

import io.github.lumbre.lab.report.ReportTable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A folder with a table of two rows, whose scenes render very fast. */
final class TinyTable {
  private static final String TEXT =
      """
      row,name,scene,size,mode,samples,bucket,depth,threads,hardware,time,note
      3,First,tiny,16x12,path,300,8,5,8,i7,1m 2s 3ms,
      4,Second,tiny,8x8,ray,4,32,,8,i5,4s 5ms,"odd, indeed."
      """;

  private TinyTable() {}

  /** Writes the folder and returns its path. */
  static Path write(Path directory) throws IOException {
    Files.createDirectories(directory);
    TinyScene.write(directory, TinyScene.JSON);
    Files.writeString(directory.resolve(ReportTable.FILE), TEXT);
    return directory;
  }
}
