package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.List;

/** Checks a scene for one kind of problem. Stateless. */
@FunctionalInterface
interface Check {
  /** Returns the findings; empty if there are none. */
  List<Finding> of(ParsedScene file, Pilot pilot);
}
