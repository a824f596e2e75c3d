package io.github.lumbre.geometry;

import java.lang.reflect.Method;

/**
 * Measures the bytes that the current thread has allocated, by reflection because the module does
 * not read the management interfaces.
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
