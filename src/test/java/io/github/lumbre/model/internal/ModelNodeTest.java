package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests which part of its file each surface belongs to, whatever the format. */
class ModelNodeTest {
  private static final String VERTICES = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  private static final String FACE = "f 1 2 3\n";
  private static final String FACET =
      " facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n";

  private static List<ModelNode> nodes(String file, String text) throws ModelFormatException {
    return new ModelFixture(file, text).read().parts().stream().map(ModelPart::node).toList();
  }

  private static List<String> labels(String file, String text) throws ModelFormatException {
    return nodes(file, text).stream().map(ModelNode::label).toList();
  }

  @Test
  void objectsOfObjFilesAreParts() throws ModelFormatException {
    String two = "o left\nusemtl a\n" + FACE + "usemtl b\n" + FACE + "o right\n" + FACE;
    List<ModelNode> nodes = nodes("a.obj", VERTICES + two);
    assertThat(nodes).extracting(ModelNode::label).containsExactly("left", "left", "right");
    assertThat(nodes.get(0)).isSameAs(nodes.get(1));
    assertThat(labels("a.obj", VERTICES + FACE + "g wheel\n" + FACE))
        .containsExactly("unnamed", "wheel");
  }

  @Test
  void filesWithoutNamesAreNotDivided() throws ModelFormatException {
    assertThat(labels("a.obj", VERTICES + FACE)).containsExactly("");
    assertThat(labels("a.stl", "solid cube\n" + FACET + "endsolid\n")).containsExactly("");
    assertThat(labels("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).containsExactly("");
    assertThat(nodes("a.stl", "solid cube\n" + FACET + "endsolid\n").get(0).isDivided()).isFalse();
  }

  @Test
  void solidsOfTextsAreParts() throws ModelFormatException {
    String text = "solid left\n" + FACET + "endsolid\nsolid\n" + FACET + "endsolid\n";
    assertThat(labels("a.stl", text)).containsExactly("left", "solid 2");
  }

  @Test
  void labelsAreShortAndWithoutControlCharacters() throws ModelFormatException {
    String name = "a\u0007\u202e" + "b".repeat(100_000);
    ModelNode node = nodes("a.obj", VERTICES + "o " + name + "\n" + FACE).get(0);
    assertThat(node.label()).isEqualTo("a\\u0007\\u202e" + "b".repeat(57) + "…");
    assertThat(node.matches(name::equals)).isTrue();
    assertThat(node.matches(node.label()::equals)).isTrue();
    assertThat(node.matches("a"::equals)).isFalse();
  }
}
