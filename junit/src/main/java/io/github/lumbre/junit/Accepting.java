package io.github.lumbre.junit;

/**
 * How a picture is accepted as golden.
 *
 * @param command for a shell
 */
record Accepting(String command) {
  /** Returns the command that runs the calling test again and stores its pictures. */
  static Accepting ofCaller(GoldenFile golden) {
    String own = GoldenPictures.class.getPackageName() + ".";
    StackWalker.StackFrame caller =
        StackWalker.getInstance()
            .walk(
                frames ->
                    frames
                        .filter(frame -> !isOwn(frame.getClassName(), own))
                        .findFirst()
                        .orElseThrow());
    String test = caller.getClassName();
    // Lambdas and nested classes run with the method or the outer class that contains them.
    String outer = test.indexOf('$') < 0 ? test : test.substring(0, test.indexOf('$'));
    String simple = outer.substring(outer.lastIndexOf('.') + 1);
    String method = caller.getMethodName();
    boolean isPlain = outer.equals(test) && method.indexOf('$') < 0 && method.indexOf('<') < 0;
    return new Accepting(
        "mvn test -Dtest=" + simple + (isPlain ? "#" + method : "") + " -Dlumbre.golden=store");
  }

  private static boolean isOwn(String className, String own) {
    String simple = className.substring(className.lastIndexOf('.') + 1);
    return className.startsWith(own)
        && (simple.equals("Accepting") || simple.equals("PictureAssert"));
  }
}
