package io.github.lumbre.cli.output;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;

/**
 * Operating system signals. Java offers them only in {@code sun.misc}: compilers warn about it and
 * some JVMs lack it. Reflection avoids both problems.
 */
public final class Signals {
  private Signals() {}

  /** Runs an action whenever the signal arrives; does nothing where signals are not supported. */
  public static void on(String name, Runnable action) {
    try {
      Class<?> signal = Class.forName("sun.misc.Signal");
      Class<?> handler = Class.forName("sun.misc.SignalHandler");
      InvocationHandler calls =
          (proxy, method, arguments) -> {
            action.run();
            return null;
          };
      Object proxy =
          Proxy.newProxyInstance(Signals.class.getClassLoader(), new Class<?>[] {handler}, calls);
      Object instance = signal.getConstructor(String.class).newInstance(name);
      signal.getMethod("handle", signal, handler).invoke(null, instance, proxy);
    } catch (ReflectiveOperationException | IllegalArgumentException e) {
      return;
    }
  }
}
