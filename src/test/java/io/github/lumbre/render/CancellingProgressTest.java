package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the listener that adds a cancellation condition. */
class CancellingProgressTest {
  /** The wrapper forwards every event of the interface, including events that are added later. */
  @Test
  void everythingIsPassedOn() throws IllegalAccessException, InvocationTargetException {
    List<String> heard = new ArrayList<>();
    Progress listener =
        (Progress)
            Proxy.newProxyInstance(
                Progress.class.getClassLoader(),
                new Class<?>[] {Progress.class},
                (proxy, method, arguments) -> {
                  heard.add(method.getName() + Arrays.toString(arguments));
                  return method.getReturnType() == boolean.class ? Boolean.FALSE : null;
                });
    Progress outer = new CancellingProgress(listener, () -> false);
    List<String> told = new ArrayList<>();
    for (Method method : Progress.class.getDeclaredMethods()) {
      if (method.isSynthetic()
          || Modifier.isStatic(method.getModifiers())
          || method.getReturnType() == Progress.class) {
        continue;
      }
      Object[] arguments =
          Arrays.stream(method.getParameterTypes()).map(CancellingProgressTest::argument).toArray();
      method.invoke(outer, arguments);
      told.add(method.getName() + Arrays.toString(arguments.length == 0 ? null : arguments));
    }
    assertThat(heard).hasSizeGreaterThan(4).isEqualTo(told);
  }

  private static Object argument(Class<?> type) {
    if (type == long.class) {
      return 7L;
    }
    return type == double.class ? (Object) 2.5 : new Crop(1, 2, 3, 4);
  }

  @Test
  void eitherMayCancel() {
    Progress cancelled =
        new Progress() {
          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    assertThat(Progress.NONE.cancelledAlsoIf(() -> false).isCancelled()).isFalse();
    assertThat(Progress.NONE.cancelledAlsoIf(() -> true).isCancelled()).isTrue();
    assertThat(cancelled.cancelledAlsoIf(() -> false).isCancelled()).isTrue();
  }
}
