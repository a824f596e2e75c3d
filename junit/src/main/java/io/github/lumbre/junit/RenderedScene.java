package io.github.lumbre.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Renders a scene or a model for a parameter of type {@link io.github.lumbre.image.Image} of a test
 * method. On a parameter or on the method. The same picture is rendered once for all tests of a
 * run.
 *
 * <pre>{@code
 * @Test
 * void helmet(@RenderedScene(value = "models/helmet.glb", view = "iso") Image picture) {
 *   assertThatPicture(picture).matches("helmet");
 * }
 * }</pre>
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.PARAMETER, ElementType.METHOD})
@ExtendWith(RenderedSceneExtension.class)
public @interface RenderedScene {
  /**
   * The path of a JSON scene, or of a glTF, OBJ, PLY, STL, OFF, 3MF or COLLADA model, from the
   * working directory or from {@code src/test/resources}.
   */
  String value();

  /**
   * For a model: front, back, left, right, top, bottom, iso, or an azimuth and an elevation in
   * degrees such as {@code -40,15}. The default is the model's first camera, or 30,20.
   */
  String view() default "";

  /** For a model: whether it stands on a gray floor. */
  boolean ground() default false;

  /** For a model: the axis of the file that points up, y or z; empty for the one that it states. */
  String up() default "";

  /** Width in pixels; 0 for that of the scene, or 320 for a model. */
  int width() default 0;

  /** Height in pixels; 0 for that of the scene, or 240 for a model. */
  int height() default 0;

  /** Samples per pixel; 0 for those of the scene, or 16 for a model. */
  int samples() default 0;

  /**
   * Whether the picture is denoised by the built-in denoiser, which gives the same bits on every
   * machine, so that a few samples make a clean picture.
   */
  boolean denoise() default false;
}
