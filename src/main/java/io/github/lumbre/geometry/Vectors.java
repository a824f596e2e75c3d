package io.github.lumbre.geometry;

import java.lang.reflect.InvocationTargetException;
import java.util.Optional;

/**
 * The way to {@link Traversal} by vectors. Its class is reached by reflection only, so that it is
 * never loaded where the module it needs is absent, and everything else compiles without.
 */
final class Vectors {
  private static final String MODULE = "jdk.incubator.vector";
  private static final String TRAVERSAL = "io.github.lumbre.geometry.VectorTraversal";
  private static final Optional<String> OBSTACLE = findObstacle();

  private Vectors() {}

  /** Returns why there can be no vectors in this virtual machine; empty if there can be. */
  static Optional<String> obstacle() {
    return OBSTACLE;
  }

  private static Optional<String> findObstacle() {
    Optional<Module> module = ModuleLayer.boot().findModule(MODULE);
    if (module.isEmpty()) {
      return Optional.of("Java runs without --add-modules " + MODULE);
    }
    Vectors.class.getModule().addReads(module.get());
    int lanes = preferredLanes();
    return lanes >= WideTree.WIDTH
        ? Optional.empty()
        : Optional.of("this processor's vectors hold " + lanes + " floats, but 8 are needed");
  }

  private static int preferredLanes() {
    try {
      return (int) Class.forName(TRAVERSAL).getDeclaredMethod("preferredLanes").invoke(null);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns the search of a tree; only if there is no obstacle. */
  static Traversal over(WideTree tree) {
    try {
      return (Traversal)
          Class.forName(TRAVERSAL).getDeclaredConstructor(WideTree.class).newInstance(tree);
    } catch (InvocationTargetException e) {
      throw new AssertionError(e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }
}
