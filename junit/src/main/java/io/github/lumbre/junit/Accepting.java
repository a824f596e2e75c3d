package io.github.lumbre.junit;

import java.lang.StackWalker.StackFrame;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Optional;
import org.junit.platform.commons.annotation.Testable;
import org.junit.platform.commons.support.AnnotationSupport;

/**
 * How a picture is accepted as golden.
 *
 * @param command for a shell
 */
record Accepting(String command) {
  /** Returns the command that runs the calling test again and stores its pictures. */
  static Accepting ofCaller() {
    List<StackFrame> frames =
        StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE)
            .walk(all -> all.filter(frame -> !isOwn(frame.getDeclaringClass())).toList());
    String test =
        frames.stream()
            .filter(Accepting::isTest)
            .findFirst()
            .map(frame -> test(frame.getDeclaringClass(), Optional.of(frame.getMethodName())))
            .orElseGet(() -> test(frames.get(0).getDeclaringClass(), Optional.empty()));
    return new Accepting("mvn test -Dtest=" + test + " -Dlumbre.golden=store");
  }

  private static boolean isOwn(Class<?> caller) {
    return caller == Accepting.class || caller == PictureAssert.class;
  }

  /** Returns whether a method is one that JUnit runs, so that helpers may call the assertion. */
  private static boolean isTest(StackFrame frame) {
    try {
      return AnnotationSupport.isAnnotated(
          frame
              .getDeclaringClass()
              .getDeclaredMethod(frame.getMethodName(), frame.getMethodType().parameterArray()),
          Testable.class);
    } catch (NoSuchMethodException e) {
      return false; // A constructor or an initializer.
    }
  }

  /**
   * Returns the name of a test for Maven.
   *
   * @param method of a class that is not nested; otherwise, the outer class runs with all its tests
   */
  private static String test(Class<?> declaring, Optional<String> method) {
    Class<?> outer = declaring;
    while (outer.getEnclosingClass() != null) {
      outer = outer.getEnclosingClass();
    }
    if (Modifier.isAbstract(outer.getModifiers())) {
      return "*" + method.map(name -> "#" + name).orElse("");
    }
    return outer.getSimpleName()
        + method.filter(name -> declaring.getEnclosingClass() == null).map(n -> "#" + n).orElse("");
  }
}
