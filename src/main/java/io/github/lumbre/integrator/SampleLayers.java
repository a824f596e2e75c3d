package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.LightGroups;
import io.github.lumbre.scene.internal.SceneInside;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Collects the {@linkplain Layer layers} of one sample while an {@link Integrator} traces its path.
 * Mutable and confined to one thread.
 */
public final class SampleLayers implements PathListener {
  /** A mirror, or clear glass, has at least this part of its albedo in clear lobes. */
  private static final double LEAST_CLEAR = .5;

  /** Directions of clear lobes have at least this density per solid angle: 6° around one. */
  private static final double LEAST_CLEAR_PDF = 30;

  private final LightGroups groups;

  /** The values of each layer, by its ordinal; empty arrays for layers that are not collected. */
  private final double[][] arrays = new double[Layer.values().length][0];

  /** The arrays that are not empty. */
  private final double[][] collected;

  /** The arrays of single layers. */
  private final double[] albedo, normal, geometricNormal, position, depth, uv;

  private final double[] direct, lights, guideAlbedo, guideNormal, guideAlpha;

  /** The normal of the ground that the camera ray passed; 0 if it passed none. */
  private final double[] ground = new double[3];

  /** The part of the light that reaches all grounds that the camera ray met. */
  private double groundLight;

  /** Whether the camera ray met a ground and ended there, as in a shadow. */
  private boolean endsInShadow;

  /** Whether single layers of the first surface are collected, besides its color. */
  private final boolean hasFirst;

  /** Whether light is collected, so that all events of a path matter. */
  private final boolean hasLight;

  /** Whether paths may have one color of three. */
  private final boolean mayDisperse;

  private Optional<RenderContext> context = Optional.empty();
  private double originX, originY, originZ;

  /** The primitive of the first surface, or -1. */
  private int firstPrimitive;

  /** The primitive that the last ray hit, or -1. */
  private int primitive;

  /** The number of surfaces that scattered the path before the last ray. */
  private int scatterings;

  /** The throughput of the last ray. */
  private double red, green, blue;

  /** The radiance of lights that the last ray hit. */
  private double glowRed, glowGreen, glowBlue;

  /** Whether the guides of denoisers are known. */
  private boolean isGuided;

  /** Whether the guides are those of the last vertex unless the path shows what is seen in it. */
  private boolean isGuidedByMirror;

  /** Whether some light of the last vertex is too blurred to show what it comes from. */
  private boolean mayBlur;

  /**
   * Creates a collector.
   *
   * @param layers the layers to collect, of those that a film stores
   */
  public SampleLayers(Set<Layer> layers, Scene scene) {
    mayDisperse = scene.poses().stream().anyMatch(Vertex::mayDisperse);
    groups = SceneInside.of(scene).lightGroups();
    for (Layer layer : layers) {
      int count = layer == Layer.LIGHTS ? 3 * groups.names().size() : layer.channels().size();
      arrays[layer.ordinal()] = new double[count];
    }
    collected = Arrays.stream(arrays).filter(a -> a.length != 0).toArray(double[][]::new);
    albedo = of(Layer.ALBEDO);
    normal = of(Layer.NORMAL);
    geometricNormal = of(Layer.GEOMETRIC_NORMAL);
    position = of(Layer.POSITION);
    depth = of(Layer.DEPTH);
    uv = of(Layer.UV);
    direct = of(Layer.DIRECT);
    lights = of(Layer.LIGHTS);
    guideAlbedo = of(Layer.DENOISING_ALBEDO);
    guideNormal = of(Layer.DENOISING_NORMAL);
    guideAlpha = of(Layer.DENOISING_ALPHA);
    hasFirst = Stream.of(normal, geometricNormal, position, depth, uv).anyMatch(a -> a.length != 0);
    hasLight = direct.length != 0 || lights.length != 0;
  }

  /**
   * Returns the sample's values of a layer: the array that the next sample overwrites. It is empty
   * if the layer is not collected. {@link Layer#LIGHTS} has three values for each light group.
   */
  public double[] of(Layer layer) {
    return arrays[layer.ordinal()];
  }

  /** Returns the primitive of the first surface, or -1 if there is none. */
  public int primitive() {
    return firstPrimitive;
  }

  /** Sets the context whose events this collector receives. */
  void listenTo(RenderContext newContext) {
    context = Optional.of(newContext);
  }

  /** Ends the events of a sample whose remaining path changes no layer. */
  private void endEvents() {
    if (!hasLight && context.isPresent()) {
      context.get().stopRecording();
    }
  }

  /** Prepares for the sample of a camera ray. */
  public void start(CameraRay ray) {
    clear();
    originX = ray.originX();
    originY = ray.originY();
    originZ = ray.originZ();
  }

  /** Sets all values to those of a sample without light and without a surface. */
  public void clear() {
    for (double[] array : collected) {
      for (int i = 0; i < array.length; i++) {
        array[i] = 0;
      }
    }
    firstPrimitive = -1;
    isGuided = guideAlbedo.length == 0 && guideNormal.length == 0;
    isGuidedByMirror = false;
    set(ground, 0, 0, 0);
    groundLight = 1;
    endsInShadow = false;
  }

  /**
   * Ends the sample.
   *
   * @param hitSomething whether it covers its pixel
   */
  public void end(boolean hitSomething) {
    if (guideAlpha.length != 0) {
      // What is behind a shadow is not known: a ground has nothing below.
      guideAlpha[0] = hitSomething && !endsInShadow ? 1 : 1 - groundLight;
    }
  }

  /** Multiplies the light of the layers by a factor, as that of a sample that is limited. */
  public void scaleLight(double factor) {
    for (int i = 0; i < direct.length; i++) {
      direct[i] *= factor;
    }
    for (int i = 0; i < lights.length; i++) {
      lights[i] *= factor;
    }
  }

  @Override
  public void rayTraced(NearestHit ray, int newScatterings, double r, double g, double b) {
    scatterings = newScatterings;
    red = r;
    green = g;
    blue = b;
    glowRed = 0;
    glowGreen = 0;
    glowBlue = 0;
    primitive = -1;
    isGuidedByMirror = false;
  }

  @Override
  public boolean measuresShadows() {
    return guideAlpha.length != 0;
  }

  @Override
  public void shadowMeasured(double blocked) {
    groundLight *= 1 - blocked;
    endsInShadow = true;
  }

  @Override
  public void litGroundPassed(SurfaceHit surface) {
    endsInShadow = false;
    setNormal(ground, surface, surface.shadingNormal());
  }

  @Override
  public void surfaceHit(NearestHit ray, Scene scene) {
    SurfaceHit surface = scene.surfaceAt(ray);
    primitive = ray.shape();
    if (isFirst()) {
      setFirst(surface);
    }
    if (!isGuided) {
      setNormal(guideNormal, surface, surface.shadingNormal());
    }
  }

  @Override
  public void vertexReached(int newPrimitive, SurfaceHit surface, Bsdf bsdf) {
    primitive = newPrimitive;
    if (isFirst()) {
      setFirst(surface);
      if (albedo.length != 0) {
        setColor(albedo, bsdf.albedo());
      }
    }
    if (!isGuided && !bsdf.isSpecular()) {
      setGuides(surface, bsdf);
    }
    if (isGuided) {
      endEvents();
    }
  }

  /** Returns whether guides are of what is seen in a surface: it is a mirror, or clear glass. */
  public static boolean isClear(Bsdf bsdf) {
    return bsdf.clearAlbedo().max() > LEAST_CLEAR * bsdf.albedo().max();
  }

  /** Sets the guides of a vertex, for good if it is no mirror and no clear glass. */
  private void setGuides(SurfaceHit surface, Bsdf bsdf) {
    Rgb color = bsdf.albedo();
    isGuidedByMirror = isClear(bsdf);
    mayBlur = bsdf.clearAlbedo().max() < color.max();
    isGuided = !isGuidedByMirror;
    setNormal(guideNormal, surface, surface.shadingNormal());
    setColor(guideAlbedo, color);
  }

  @Override
  public void scattered(BsdfSample sample, double survival, boolean survives) {
    boolean isBlurred = !sample.isSpecular() && sample.pdf() < LEAST_CLEAR_PDF;
    if (!isGuided && isGuidedByMirror && mayBlur && isBlurred) {
      isGuided = true;
      endEvents();
    }
  }

  private boolean isFirst() {
    return scatterings == 0;
  }

  private void setFirst(SurfaceHit surface) {
    firstPrimitive = primitive;
    if (!hasFirst) {
      return;
    }
    setNormal(normal, surface, surface.shadingNormal());
    setNormal(geometricNormal, surface, surface.geometricNormal());
    if (uv.length != 0) {
      uv[0] = surface.u();
      uv[1] = surface.v();
    }
    if (position.length != 0 || depth.length != 0) {
      Vec3 at = surface.position();
      set(position, at.x(), at.y(), at.z());
      double x = at.x() - originX;
      double y = at.y() - originY;
      double z = at.z() - originZ;
      if (depth.length != 0) {
        depth[0] = Math.sqrt(x * x + y * y + z * z);
      }
    }
  }

  private static void set(double[] array, double x, double y, double z) {
    if (array.length != 0) {
      array[0] = x;
      array[1] = y;
      array[2] = z;
    }
  }

  /** Sets a normal, on the side of the viewer. */
  private static void setNormal(double[] array, SurfaceHit surface, Vec3 normal) {
    if (array.length != 0) {
      double side = normal.dot(surface.wo()) < 0 ? -1 : 1;
      set(array, side * normal.x(), side * normal.y(), side * normal.z());
    }
  }

  /** Sets the color of the surface that the last ray hit, tinted by what the path passed before. */
  private void setColor(double[] array, Rgb color) {
    if (array.length != 0) {
      double most = mostThroughput();
      set(
          array,
          tinted(red, color.r() + glowRed, most),
          tinted(green, color.g() + glowGreen, most),
          tinted(blue, color.b() + glowBlue, most));
    }
  }

  /**
   * Returns the largest throughput of the last ray that counts: 3 if glass dispersed the light, so
   * that the path has one color and stands for three paths.
   */
  private double mostThroughput() {
    if (!mayDisperse) {
      return 1;
    }
    int colors = (red > 0 ? 1 : 0) + (green > 0 ? 1 : 0) + (blue > 0 ? 1 : 0);
    return colors == 1 ? 3 : 1;
  }

  private static double tinted(double throughput, double color, double most) {
    return Math.min(most, throughput * Math.min(1, color));
  }

  @Override
  public void lightSampled(
      Source source,
      int emitter,
      LightSample light,
      BsdfValue value,
      double lightPdf,
      double misWeight,
      boolean blocked) {
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    if (blocked || r == 0 && g == 0 && b == 0) {
      return;
    }
    double weight = misWeight / lightPdf;
    int times = scatterings + (source == Source.MIRROR || source == Source.REFRACTION ? 2 : 1);
    add(group(source, emitter), times, r * weight, g * weight, b * weight);
  }

  @Override
  public void lightFound(
      Source source,
      int emitter,
      double r,
      double g,
      double b,
      double lightPdf,
      double bsdfPdf,
      double misWeight) {
    boolean isAmbient = source == Source.AMBIENT;
    if (!isAmbient) {
      glowRed += r;
      glowGreen += g;
      glowBlue += b;
    }
    if (source == Source.EMISSION && isFirst()) {
      setColor(albedo, Rgb.BLACK);
    }
    add(
        group(source, emitter),
        isAmbient ? scatterings + 1 : scatterings,
        r * misWeight,
        g * misWeight,
        b * misWeight);
  }

  /** Returns the group of a light, or -1 if it has none or groups are not collected. */
  private int group(Source source, int emitter) {
    if (lights.length == 0) {
      return -1;
    }
    if (emitter >= 0) {
      return groups.ofEmitter(emitter);
    }
    return source == Source.EMISSION ? groups.ofPrimitive(primitive) : -1;
  }

  /**
   * Adds light.
   *
   * @param group of the light, or -1
   * @param times how often the light was scattered
   */
  private void add(int group, int times, double r, double g, double b) {
    if (times <= 1 && direct.length != 0) {
      direct[0] += red * r;
      direct[1] += green * g;
      direct[2] += blue * b;
    }
    if (group >= 0) {
      lights[3 * group] += red * r;
      lights[3 * group + 1] += green * g;
      lights[3 * group + 2] += blue * b;
    }
  }

  @Override
  public void pathEnded(End end) {
    if (isGuided || isGuidedByMirror && end == End.SPLIT) {
      return;
    }
    isGuided = true;
    if (!isGuidedByMirror) {
      setColor(guideAlbedo, Rgb.BLACK);
      if (end == End.ESCAPED) {
        // Only the ray of the camera passes a ground, and it may have been reflected since.
        double seen = isFirst() ? 1 : 0;
        set(guideNormal, seen * ground[0], seen * ground[1], seen * ground[2]);
      }
    }
  }
}
