package io.github.lumbre.scenefile.internal;

import io.github.lumbre.scenefile.SceneParser;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.BiFunction;

/** Makes parsers for measurements, whose textures count their lookups. */
public final class CountingParser {
  private static BiFunction<SceneParser, LongAdder, SceneParser> maker;

  private CountingParser() {}

  /** Sets how such parsers are made. The class of parsers calls it once, before there are any. */
  public static void madeBy(BiFunction<SceneParser, LongAdder, SceneParser> newMaker) {
    maker = newMaker;
  }

  /** Returns the same parser, whose textures increment a counter at each lookup. */
  public static SceneParser of(SceneParser parser, LongAdder lookUps) {
    return maker.apply(parser, lookUps);
  }
}
