package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;

/** Orders in which buckets may be rendered, for {@link FilmRenderer#inOrder}. */
final class Orders {
  private Orders() {}

  /** Returns the order that is another one, at random, for each pass. */
  static UnaryOperator<List<Bucket>> shuffled(Random random) {
    return buckets -> {
      List<Bucket> result = new ArrayList<>(buckets);
      Collections.shuffle(result, random);
      return result;
    };
  }
}
