package io.github.lumbre.audit;

import io.github.lumbre.parser.SceneFile;
import java.util.List;

/** Looks at a scene for one kind of thing. Without state. */
@FunctionalInterface
interface Check {
  /** Returns the findings, the most severe first. */
  List<Finding> of(SceneFile file, Pilot pilot);
}
