package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;

/** Bucket orders for {@link FilmRenderer#inOrder}. */
final class Orders {
  private Orders() {}

  /** Returns an order that is shuffled again for each pass. */
  static UnaryOperator<List<Crop>> shuffled(Random random) {
    return buckets -> {
      List<Crop> result = new ArrayList<>(buckets);
      Collections.shuffle(result, random);
      return result;
    };
  }
}
