package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;

/** Bucket orders for {@link FilmRenderer#inOrder}. */
final class Orders {
  private Orders() {}

  /** Returns an order that is shuffled again for each pass. */
  static UnaryOperator<List<Bucket>> shuffled(Random random) {
    return buckets -> {
      List<Bucket> result = new ArrayList<>(buckets);
      Collections.shuffle(result, random);
      return result;
    };
  }
}
