package io.github.lumbre.render.checkpoint.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageLayer.Precision;
import io.github.lumbre.image.internal.Cryptomatte;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.internal.SurfaceNames;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntFunction;

/**
 * A developed film with its layers, as OpenEXR files hold them.
 *
 * @param image the picture
 * @param layers the layers of the picture
 * @param metadata attributes of the file that describe the layers, by name
 */
public record FilmPicture(Image image, List<ImageLayer> layers, Map<String, String> metadata) {
  /** The name of the layer with the light of lights without a group, after {@code lights.}. */
  private static final String UNGROUPED = "other";

  /** The layers whose values need more than 11 bits, or more than the range of a half. */
  private static final Set<Layer> WIDE =
      Layer.setOf(
          Layer.POSITION,
          Layer.DEPTH,
          Layer.UV,
          Layer.SAMPLES,
          Layer.VARIANCE,
          Layer.DIRECT,
          Layer.INDIRECT);

  public FilmPicture {
    layers = List.copyOf(layers);
  }

  /** Returns a film's picture with all its layers. */
  public static FilmPicture of(Film film, RecordedLayers recorded) {
    return of(film, recorded, recorded.kinds());
  }

  /**
   * Returns a film's picture with some of its layers.
   *
   * @param recorded the layers of the film
   * @param wanted the layers to develop; those that the film does not have are left out
   */
  public static FilmPicture of(Film film, RecordedLayers recorded, Set<Layer> wanted) {
    List<ImageLayer> layers = new ArrayList<>();
    Map<String, String> metadata = new LinkedHashMap<>();
    SurfaceNames names = new SurfaceNames(recorded.objects(), recorded.materials());
    Set<Layer> found = EnumSet.noneOf(Layer.class);
    found.addAll(wanted);
    found.retainAll(recorded.kinds());
    for (Layer layer : found) {
      switch (layer) {
        case OBJECT -> add(matte("CryptoObject", film, names::object), layers, metadata);
        case MATERIAL -> add(matte("CryptoMaterial", film, names::material), layers, metadata);
        case LIGHTS -> layers.addAll(lights(film, recorded.lightGroups()));
        default -> layers.add(layer(film, layer.text(), layer, film.develop(layer)));
      }
    }
    return new FilmPicture(film.develop(), layers, metadata);
  }

  private static ImageLayer layer(Film film, String name, Layer layer, float[] values) {
    return new ImageLayer(
        name,
        layer.channels(),
        WIDE.contains(layer) || layer == Layer.LIGHTS ? Precision.FLOAT : Precision.HALF,
        film.window().width(),
        film.window().height(),
        values);
  }

  private static List<ImageLayer> lights(Film film, List<String> groups) {
    List<ImageLayer> layers = new ArrayList<>();
    List<String> names = lightNames(groups);
    for (int i = 0; i < groups.size(); i++) {
      layers.add(layer(film, names.get(i), Layer.LIGHTS, film.developLightGroup(i)));
    }
    String rest = names.get(groups.size());
    layers.add(layer(film, rest, Layer.LIGHTS, film.developUngroupedLight()));
    return layers;
  }

  /**
   * Returns the names of the layers that {@link Layer#LIGHTS} is written as: one for each light
   * group, and one for the light of lights without a group.
   */
  public static List<String> lightNames(List<String> groups) {
    List<String> names = new ArrayList<>(groups);
    names.add(groups.contains(UNGROUPED) ? "ungrouped" : UNGROUPED);
    return names.stream().map(name -> Layer.LIGHTS.text() + "." + name).toList();
  }

  private static void add(
      Cryptomatte matte, List<ImageLayer> layers, Map<String, String> metadata) {
    layers.addAll(matte.layers());
    metadata.putAll(matte.metadata());
  }

  private static Cryptomatte matte(String type, Film film, IntFunction<String> names) {
    int width = film.window().width();
    return Cryptomatte.of(
        type,
        width,
        film.window().height(),
        pixel -> {
          int x = film.window().x() + pixel % width;
          int y = film.window().y() + pixel / width;
          // Whole numbers, because sums of shares would depend on the order of the primitives.
          Map<String, Integer> hits = new LinkedHashMap<>();
          film.primitives(pixel)
              .forEach((hit, count) -> hits.merge(names.apply(hit), count, Integer::sum));
          float samples = film.samples(x, y);
          Map<String, Float> shares = new LinkedHashMap<>();
          hits.forEach((name, count) -> shares.put(name, count / samples));
          return shares;
        });
  }
}
