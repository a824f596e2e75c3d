package io.github.lumbre.mutants;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.platform.engine.FilterResult;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.PostDiscoveryFilter;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/** Runs tests and ends the process at the first that fails. */
final class NamedTests {
  /** What the process ends with: all tests passed, one failed, or some could not be run. */
  static final int PASSED = 0;

  static final int FAILED = 10;
  static final int UNUSABLE = 11;

  private static final String ROOT = "io.github.lumbre.";

  private NamedTests() {}

  /**
   * Runs the tests of classes, or of methods: {@code math.Vec3Test}, {@code math.Vec3Test#sum}.
   * Prints the name of the test that fails.
   */
  public static void main(String[] tests) throws ClassNotFoundException {
    Set<String> missing = new TreeSet<>(List.of(tests));
    boolean[] failed = new boolean[1];
    TestExecutionListener listener =
        new TestExecutionListener() {
          @Override
          public void executionStarted(TestIdentifier test) {
            if (test.getSource().orElse(null) instanceof MethodSource method) {
              missing.remove(nameOf(method));
              missing.remove(classOf(method));
            }
          }

          @Override
          public void executionFinished(TestIdentifier test, TestExecutionResult result) {
            if (result.getStatus() == TestExecutionResult.Status.FAILED && !failed[0]) {
              failed[0] = true;
              System.out.println(describe(test, result));
              Runtime.getRuntime().halt(fits(result) ? FAILED : UNUSABLE);
            }
          }
        };
    Launcher launcher = LauncherFactory.create();
    launcher.execute(request(tests), listener);
    if (!missing.isEmpty()) {
      System.out.println("no such tests: " + missing);
    }
    // Threads that a test left behind do not matter.
    Runtime.getRuntime().halt(missing.isEmpty() ? PASSED : UNUSABLE);
  }

  private static LauncherDiscoveryRequest request(String[] tests) throws ClassNotFoundException {
    Set<String> wanted = Set.of(tests);
    List<Class<?>> classes = new ArrayList<>();
    for (String test : tests) {
      classes.add(Class.forName(ROOT + test.split("#")[0]));
    }
    PostDiscoveryFilter filter =
        test ->
            FilterResult.includedIf(
                !(test.getSource().orElse(null) instanceof MethodSource method)
                    || wanted.contains(nameOf(method))
                    || wanted.contains(classOf(method)));
    return LauncherDiscoveryRequestBuilder.request()
        .selectors(classes.stream().distinct().map(DiscoverySelectors::selectClass).toList())
        .filters(filter)
        .build();
  }

  /**
   * Tells whether a test failed by itself, and not because changed and other classes do not fit.
   */
  private static boolean fits(TestExecutionResult result) {
    return !(result.getThrowable().orElse(null) instanceof LinkageError);
  }

  private static String classOf(MethodSource method) {
    return method.getClassName().substring(ROOT.length());
  }

  private static String nameOf(MethodSource method) {
    return classOf(method) + "#" + method.getMethodName();
  }

  private static String describe(TestIdentifier test, TestExecutionResult result) {
    String name =
        test.getSource().orElse(null) instanceof MethodSource method
            ? nameOf(method)
            : test.getDisplayName();
    String fault = result.getThrowable().map(Throwable::toString).orElse("no fault");
    String line = fault.strip().replaceAll("\\s+", " ");
    return name + ": " + line.substring(0, Math.min(line.length(), 160));
  }
}
