package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.networknt.schema.InputFormat;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import io.github.lumbre.cli.ModelSample;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that what tools return is what their schemas say, member by member. */
class OutputSchemaTest {
  private static final String SMALL = "'model':'sample.glb','width':32,'height':24,'samples':1";
  private static final String SCENE = SMALL.replace("sample.glb", "s.json");

  private static final List<List<String>> CALLS =
      List.of(
          List.of("views", SMALL + ",'labels':['parts']"),
          List.of("render", SMALL),
          List.of("render", SMALL + ",'crop':'body'"),
          List.of("render", SMALL + ",'view':'0,0','fov':1e-9"),
          List.of("render", SCENE),
          List.of("section", SMALL + ",'planes':['x=50%']"),
          List.of("describe", "'model':'sample.glb'"),
          List.of("describe", "'model':'a.obj'"),
          List.of("describe", "'model':'s.json'"),
          List.of("pixel", SMALL + ",'x':16,'y':12"),
          List.of("pixel", SMALL + ",'x':0,'y':0"),
          List.of("pixel", SMALL + ",'x':16,'y':12,'paths':true"),
          List.of("pixel", SCENE + ",'x':16,'y':12"),
          List.of("diff", "'old':'sample.glb','new':'sample.glb','width':32,'height':24"),
          List.of("diff", "'old':'a.obj','new':'b.obj','width':32,'height':24"),
          List.of("diff", "'old':'a.obj','new':'sample.glb','width':32,'height':24"),
          List.of("compare", "'picture':'paint.png','reference':'paint.png'"));

  @TempDir private Path folder;
  private McpClient client;
  private final Map<String, JsonObject> schemas = new TreeMap<>();

  @BeforeEach
  void start() throws Exception {
    ModelSample.write(folder);
    String a = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 2\nv 1 0 2\nv 0 1 2\nf 4 5 6\n";
    Files.writeString(folder.resolve("a.obj"), a);
    Files.writeString(folder.resolve("b.obj"), a.replace(" 2\n", " 2.5\n"));
    Files.writeString(
        folder.resolve("s.json"),
        ("{'version': '2.1', 'mainCameraId': 1, 'assets': [],"
                + " 'objects': [{'id': 1, 'type': 'Camera', 'cameraType': 'Pinhole'}]}")
            .replace('\'', '"'));
    client = new McpClient((in, out) -> Mcp.serve(List.of(folder), in, out));
    client.send(
        ("{'jsonrpc':'2.0','id':1,'method':'tools/list','params':{"
                + McpClient.META.substring(0, McpClient.META.length() - 1)
                + "}}\n")
            .replace('\'', '"'));
    for (JsonElement tool : client.next().getAsJsonObject("result").getAsJsonArray("tools")) {
      JsonObject listed = tool.getAsJsonObject();
      schemas.put(listed.get("name").getAsString(), listed.getAsJsonObject("outputSchema"));
    }
  }

  @AfterEach
  void end() throws IOException {
    client.close();
  }

  @Test
  void allResultsSuitTheirSchemas() throws Exception {
    assertThat(CALLS.stream().map(call -> call.get(0))).containsAll(schemas.keySet());
    for (List<String> call : CALLS) {
      JsonObject values = client.numbers(call.get(0), call.get(1));
      JsonObject schema = schemas.get(call.get(0)).deepCopy();
      assertThat(schema.get("type").getAsString()).isEqualTo("object");
      JsonSchema closed =
          JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(closed(schema).toString());
      assertThat(closed.validate(values.toString(), InputFormat.JSON))
          .as("%s %s", call, values)
          .isEmpty();
    }
  }

  /** Returns a schema that forbids members that it does not name. */
  private static JsonElement closed(JsonElement schema) {
    if (schema.isJsonObject()) {
      JsonObject object = schema.getAsJsonObject();
      object.asMap().values().forEach(OutputSchemaTest::closed);
      if (object.has("properties") && object.get("properties").isJsonObject()) {
        object.addProperty("additionalProperties", false);
      }
    }
    return schema;
  }

  /** Members that are in no result would be promises that nobody keeps. */
  @Test
  void allMembersAreInSomeResult() throws Exception {
    for (Map.Entry<String, JsonObject> tool : schemas.entrySet()) {
      StringBuilder all = new StringBuilder();
      for (List<String> call : CALLS) {
        if (call.get(0).equals(tool.getKey())) {
          all.append(client.numbers(call.get(0), call.get(1)));
        }
      }
      for (String name : tool.getValue().getAsJsonObject("properties").keySet()) {
        if (!isOfOtherTool(tool.getKey(), name)) {
          assertThat(all.toString()).as(tool.getKey()).contains("\"" + name + "\":");
        }
      }
    }
  }

  /** Returns whether a member is that of another tool with the same kind of pictures. */
  private static boolean isOfOtherTool(String tool, String name) {
    return !tool.equals("render") && List.of("crop", "scene").contains(name);
  }
}
