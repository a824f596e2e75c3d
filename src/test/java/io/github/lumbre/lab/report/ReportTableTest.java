package io.github.lumbre.lab.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the report table and its errors. */
class ReportTableTest {
  private static final String HEADER =
      "row,name,scene,size,mode,samples,bucket,depth,threads,hardware,time,note\n";

  @TempDir private Path directory;

  private static List<ReportRow> projects() throws TaskException {
    return ReportTable.load(Path.of("scenes"));
  }

  @Test
  void projectsTableHasTheRowsOfTheReport() throws TaskException {
    List<ReportRow> rows = projects();
    assertThat(rows)
        .extracting(ReportRow::number)
        .containsExactlyElementsOf(IntStream.rangeClosed(1, 17).boxed().toList());
    assertThat(rows).allMatch(row -> row.reportTime().matches("(\\d+h )?(\\d+m )?\\d+s \\d+ms"));
    assertThat(rows.stream().filter(row -> !row.note().isEmpty()).map(ReportRow::number))
        .containsExactly(5, 6, 7, 8);
    assertThat(rows.stream().mapToLong(ReportRow::samples).sum()).isEqualTo(60308);
  }

  @Test
  void scenesOfTheTableSayWhatItSays() throws TaskException, SceneFormatException, IOException {
    SceneFolder folder = new SceneFolder(Path.of("scenes"));
    for (ReportRow row : projects()) {
      RenderSettings inScene = new SceneParser().parse(folder.file(row.scene())).settings();
      assertThat(inScene).as(row.scene()).isEqualTo(row.over(inScene));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1,A,a,8x4,path,9,32,5,8,i7,1s         | line 2: expected 12 values, found 11",
        "x,A,a,8x4,path,9,32,5,8,i7,1s,        | line 2: For input string: \"x\"",
        "1,A,a,8*4,path,9,32,5,8,i7,1s,        | line 2: expected WxH",
        "1,A,a,8x4,both,9,32,5,8,i7,1s,        | line 2: expected one of ray, path",
        "1,A,a,8x4,path,0,32,5,8,i7,1s,        | line 2: samples: expected 1 to",
        "1,A,a,8x4,path,9,0,5,8,i7,1s,         | line 2: bucketSize: expected 1 to",
      })
  void wrongLinesAreNamed(String line, String message) throws IOException {
    Files.writeString(directory.resolve(ReportTable.FILE), HEADER + line);
    assertThatThrownBy(() -> ReportTable.load(directory))
        .isInstanceOf(TaskException.class)
        .hasMessageContaining(ReportTable.FILE)
        .hasMessageContaining(message);
  }

  @Test
  void otherHeadersAreRefused() throws IOException {
    Files.writeString(directory.resolve(ReportTable.FILE), "a,b\n");
    assertThatThrownBy(() -> ReportTable.load(directory)).hasMessageContaining("line 1");
  }
}
