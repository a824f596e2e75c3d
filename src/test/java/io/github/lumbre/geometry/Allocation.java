package io.github.lumbre.geometry;

import java.lang.reflect.Method;

/**
 * How many bytes this thread has allocated. By reflection, since the module does not read the
 * management interfaces that say so.
 */
final class Allocation {
  private Allocation() {}

  static long ofThisThread() throws ReflectiveOperationException {
    Object bean =
        Class.forName("java.lang.management.ManagementFactory")
            .getMethod("getThreadMXBean")
            .invoke(null);
    Method bytes =
        Class.forName("com.sun.management.ThreadMXBean")
            .getMethod("getThreadAllocatedBytes", long.class);
    return (long) bytes.invoke(bean, Thread.currentThread().getId());
  }
}
