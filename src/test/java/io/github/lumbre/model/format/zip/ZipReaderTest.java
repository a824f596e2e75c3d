package io.github.lumbre.model.format.zip;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.FileMutator;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests models whose files are in archives, in memory and among the resources of a program. */
class ZipReaderTest {
  private static final int QUICK = 1000;
  private static final int MANY = 100_000;
  private static final byte[] PNG = Pixels.of(1, 1, 3, new byte[] {10, 20, 30}).toPng();
  private static final byte[] OBJ =
      ascii(
          "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 .5\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
              + "f 1/1 2/2 3/3\n");

  private static final String PLAIN = "v 0 0 0\nv 1 0 0\nv 0 1 .5\nf 1 2 3\n";

  @TempDir private Path directory;

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }

  /** Returns an OBJ file, its materials and their picture in a folder. */
  private static Map<String, byte[]> files(String folder, String picture) {
    Map<String, byte[]> files = new TreeMap<>();
    files.put(folder + "a.obj", OBJ);
    files.put(folder + "a.mtl", ascii("newmtl m\nmap_Kd " + picture + "\n"));
    return files;
  }

  private static Map<String, byte[]> archived() {
    Map<String, byte[]> files = files("models/", "../pictures/a.png");
    files.put("pictures/a.png", PNG);
    files.put("__MACOSX/models/a.obj", new byte[9]);
    files.put("models/._a.obj", new byte[9]);
    files.put("read me.txt", new byte[9]);
    return files;
  }

  private static Map<String, byte[]> alone() {
    Map<String, byte[]> files = files("", "a.png");
    files.put("a.png", PNG);
    return files;
  }

  private static byte[] zip(Map<String, byte[]> files) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        zip.putNextEntry(new ZipEntry(file.getKey()));
        zip.write(file.getValue());
      }
    }
    return out.toByteArray();
  }

  private static Model read(String name, byte[] zip) throws ModelFormatException, IOException {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.UPLOADS);
    return ModelReader.read(name, zip, ModelFolder.NONE, options);
  }

  private static String refusal(Map<String, byte[]> files) throws IOException {
    byte[] zip = zip(files);
    return catchThrowableOfType(ModelFormatException.class, () -> read("a.zip", zip)).getMessage();
  }

  private static byte[] picture(String name, byte[] model, ModelFolder files) throws Exception {
    SceneParser parser =
        new SceneParser()
            .limitedTo(Limits.UPLOADS)
            .overriding(settings -> settings.toBuilder().size(8, 8).samples(1).build());
    SceneFile scene = StagedModel.read(name, model, files, Stage.DEFAULT, parser).scene();
    assertThat(scene.warnings()).isEmpty();
    return new PictureRenderer(scene.settings()).render(scene.scene()).toPfm();
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.zip", "A.ZIP", "upload"})
  void aModelFindsItsFilesInTheArchive(String name) throws Exception {
    byte[] zip = zip(archived());
    assertThat(read(name, zip).warnings()).isEmpty();
    assertThat(picture(name, zip, ModelFolder.NONE))
        .isEqualTo(picture("a.obj", OBJ, ModelFolder.of(alone())))
        .isNotEqualTo(picture("a.obj", ascii(PLAIN), ModelFolder.NONE));
  }

  @Test
  void filesOfTheClassPathAreFound() throws Exception {
    Path folder = Files.createDirectories(directory.resolve("some/models"));
    for (Map.Entry<String, byte[]> file : alone().entrySet()) {
      Files.write(folder.resolve(file.getKey()), file.getValue());
    }
    try (URLClassLoader loader = new URLClassLoader(new URL[] {directory.toUri().toURL()})) {
      ModelFolder resources = ModelFolder.of(loader, "some/models");
      assertThat(picture("a.obj", resources.read("a.obj", ""), resources))
          .isEqualTo(picture("a.obj", OBJ, ModelFolder.of(alone())));
      for (String name : new String[] {"../models/a.obj", "/a.obj", "", ".", "../../a.obj"}) {
        assertThatThrownBy(() -> resources.read(name, "here"))
            .hasMessage("here: expected a file inside the model's folder, found \"" + name + "\"");
      }
      assertThatThrownBy(() -> resources.read("b.obj", "here"))
          .hasMessage("here: expected a file, found none at \"b.obj\"");
    }
  }

  @Test
  void filesOutsideTheArchiveAreLeftOut() throws Exception {
    Map<String, byte[]> files = files("models/", "../../etc/passwd");
    assertThat(read("a.zip", zip(files)).warnings())
        .singleElement()
        .asString()
        .contains("expected a file inside the model's folder, found \"../../etc/passwd\"");
  }

  @Test
  void anArchiveHasOneModel() throws Exception {
    Map<String, byte[]> files = alone();
    files.put("b.stl", new byte[9]);
    assertThat(refusal(files))
        .isEqualTo("expected one model in the archive, found several: \"a.obj\" or \"b.stl\"");
    files.remove("a.obj");
    files.remove("b.stl");
    files.put("inside.zip", zip(alone()));
    assertThat(refusal(files)).isEqualTo("expected one model in the archive, found none");
    files.put("../a.obj", OBJ);
    assertThat(refusal(files)).isEqualTo("expected names inside the archive, found \"../a.obj\"");
  }

  @Test
  void inflatedBytesCountAsBytesOfTheUpload() throws Exception {
    Map<String, byte[]> files = alone();
    files.put("a.mtl", new byte[1_000_000]);
    byte[] zip = zip(files);
    Limits limits = Limits.UPLOADS.withBytes(900_000);
    SceneParser parser = new SceneParser().limitedTo(limits);
    assertTooLarge(() -> StagedModel.read("a.zip", zip, ModelFolder.NONE, Stage.DEFAULT, parser));
    ModelFolder folder = ModelFolder.of(files);
    assertTooLarge(() -> StagedModel.read("a.obj", OBJ, folder, Stage.DEFAULT, parser));
  }

  private static void assertTooLarge(ThrowingCallable read) {
    SceneFormatException thrown = catchThrowableOfType(SceneFormatException.class, read);
    assertThat(thrown.kind()).isEqualTo(SceneFormatException.Kind.LIMIT);
  }

  @Test
  void streamsAreReadWithinTheLimit() throws Exception {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.UPLOADS.withBytes(OBJ.length));
    ByteArrayInputStream stream = new ByteArrayInputStream(OBJ);
    assertThat(Models.read("a.obj", stream, ModelFolder.of(alone()), options).files())
        .containsOnlyKeys("a.mtl", "a.png");
    ByteArrayInputStream longer = new ByteArrayInputStream(new byte[100_000]);
    assertThatThrownBy(() -> Models.read("a.obj", longer, ModelFolder.NONE, options))
        .isInstanceOf(ModelFormatException.class)
        .hasMessageContaining("bytes, found " + (OBJ.length + 1));
    assertThat(longer.available()).isEqualTo(100_000 - OBJ.length - 1);
  }

  private static void mutate(long seed, int count) throws IOException {
    byte[] zip = zip(archived());
    int readable = 0;
    for (int i = 0; i < count; i++) {
      byte[] changed = new FileMutator(new Random(seed + i)).changed(zip, zip.length);
      try {
        readable += read("a.zip", changed).parts().size();
      } catch (ModelFormatException e) {
        assertThat(e.getMessage())
            .as("seed %d", seed + i)
            .contains("expected")
            .hasSizeLessThan(500);
      }
    }
    assertThat(readable).isBetween(count / 50, count * 49 / 50);
  }

  @Test
  void changedArchivesAreReadOrRefused() throws IOException {
    mutate(1, QUICK);
  }

  @Test
  @Tag("fuzz")
  void manyChangedArchivesAreReadOrRefused() throws IOException {
    mutate(Long.getLong("lumbre.fuzz.seed", System.nanoTime()), MANY);
  }
}
