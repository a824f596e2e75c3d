package io.github.lumbre.geometry;

import java.lang.module.ModuleFinder;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;

/**
 * Gives access to the vector traversal by reflection only. Its class is therefore not loaded where
 * its module is absent, and all other classes compile without that module.
 */
final class Vectors {
  private static final String MODULE = VectorLanes.MODULE;
  private static final String TRAVERSAL = "io.github.lumbre.geometry.VectorTraversal";

  private static final Optional<Module> LOADED =
      ModuleLayer.boot().findModule(MODULE).or(Vectors::loadModule);

  private static final Optional<String> OBSTACLE = findObstacle();

  private Vectors() {}

  /** Returns the reason why vectors are not available in this JVM; empty if they are available. */
  static Optional<String> obstacle() {
    return OBSTACLE;
  }

  /** Returns whether Java has the module and has loaded it. */
  static boolean isLoaded() {
    return LOADED.isPresent();
  }

  private static Optional<String> findObstacle() {
    if (LOADED.isEmpty()) {
      return Optional.of(
          ModuleFinder.ofSystem().find(MODULE).isPresent()
              ? "Java runs without --add-modules " + MODULE
              : "this Java has no module " + MODULE);
    }
    Vectors.class.getModule().addReads(LOADED.get());
    return VectorLanes.obstacle(VectorLanes.ofModule());
  }

  /**
   * Loads the module as Java itself loads modules that are needed late. Java starts faster without
   * {@code --add-modules}, and prints no warning. Its package is exported by the manifest of the
   * command-line jar.
   *
   * @return the module; empty where Java does not export that package or has no such module
   */
  private static Optional<Module> loadModule() {
    try {
      Class<?> modules = Class.forName("jdk.internal.module.Modules");
      Object module = modules.getMethod("loadModule", String.class).invoke(null, MODULE);
      return Optional.of((Module) module);
    } catch (ReflectiveOperationException e) {
      return Optional.empty();
    }
  }

  /** Returns the traversal of a tree; call it only if there is no obstacle. */
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
