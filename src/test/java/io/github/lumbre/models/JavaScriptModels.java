package io.github.lumbre.models;

import com.google.gson.JsonElement;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;

/**
 * Turns the models in packages of JavaScript into files: data URIs, arrays of positions and cells,
 * and compressed PLY files.
 */
final class JavaScriptModels {
  private static final Pattern DATA = Pattern.compile("[\"']data:[^,\"']*;base64,([^\"']*)[\"']");
  private static final Pattern POSITIONS = array("positions");
  private static final Pattern CELLS = array("cells");
  private static final int GLB_MAGIC = 0x676c5446;

  private JavaScriptModels() {}

  private static Pattern array(String name) {
    return Pattern.compile("exports\\." + name + "\\s*=\\s*(\\[\\[[^;]*?\\]\\])", Pattern.DOTALL);
  }

  /** Writes the models of a package beside their sources. */
  static void unpack(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.filter(Files::isRegularFile).toList();
    }
    for (Path file : files) {
      String name = file.getFileName().toString();
      if (name.endsWith(".ply.gz")) {
        try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
          Files.copy(in, file.resolveSibling(name.substring(0, name.length() - 3)));
        }
      } else if (name.endsWith(".js")) {
        script(file, Files.readString(file));
      }
    }
  }

  private static void script(Path file, String text) throws IOException {
    String name = file.getFileName().toString().replaceFirst("\\.js$", "");
    Matcher data = DATA.matcher(text);
    Matcher positions = POSITIONS.matcher(text);
    Matcher cells = CELLS.matcher(text);
    if (data.find()) {
      byte[] content = Base64.getDecoder().decode(data.group(1));
      boolean isGlb = content.length > 4 && ByteBuffer.wrap(content).getInt() == GLB_MAGIC;
      boolean isNamed = name.endsWith(".glb");
      Files.write(file.resolveSibling(isGlb && !isNamed ? name + ".glb" : name), content);
    } else if (positions.find() && cells.find()) {
      Files.writeString(
          file.resolveSibling(name + ".obj"),
          lines("v", positions.group(1), UnaryOperator.identity())
              + lines("f", cells.group(1), index -> Integer.toString(Integer.parseInt(index) + 1)));
    }
  }

  /** Returns a line of an OBJ file for each row. */
  private static String lines(String key, String rows, UnaryOperator<String> number) {
    StringBuilder text = new StringBuilder();
    for (JsonElement row : JsonParser.parseString(rows).getAsJsonArray()) {
      text.append(key);
      for (JsonElement value : row.getAsJsonArray()) {
        text.append(' ').append(number.apply(value.getAsString()));
      }
      text.append('\n');
    }
    return text.toString();
  }
}
