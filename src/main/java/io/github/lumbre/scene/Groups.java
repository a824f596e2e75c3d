package io.github.lumbre.scene;

import io.github.lumbre.math.Transform;
import io.github.lumbre.scene.internal.SceneNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Finds groups in the description of a scene. */
final class Groups {
  private Groups() {}

  /** Returns the nodes with another transform of one group. */
  static List<SceneNode> placed(List<SceneNode> nodes, String name, Transform transform) {
    List<String> names = names(nodes);
    if (!names.contains(name)) {
      throw new IllegalArgumentException(
          "group: expected one of " + names + ", found \"" + name + '"');
    }
    return replaced(nodes, name, transform);
  }

  private static List<SceneNode> replaced(List<SceneNode> nodes, String name, Transform transform) {
    List<SceneNode> result = new ArrayList<>();
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Group group) {
        result.add(
            group.name().equals(name)
                ? new SceneNode.Group(name, transform, group.children())
                : new SceneNode.Group(
                    group.name(), group.transform(), replaced(group.children(), name, transform)));
      } else {
        result.add(node);
      }
    }
    return result;
  }

  /**
   * Checks that no two groups have the same name.
   *
   * @throws IllegalStateException if two have
   */
  static void requireDistinct(List<SceneNode> nodes) {
    Set<String> known = new HashSet<>();
    for (String name : names(nodes)) {
      if (!known.add(name)) {
        throw new IllegalStateException(
            "groups: expected each name once, found \"" + name + "\" again");
      }
    }
  }

  private static List<String> names(List<SceneNode> nodes) {
    List<String> names = new ArrayList<>();
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Group group) {
        names.add(group.name());
        names.addAll(names(group.children()));
      }
    }
    return names;
  }
}
