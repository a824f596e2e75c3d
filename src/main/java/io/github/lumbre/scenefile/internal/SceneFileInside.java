package io.github.lumbre.scenefile.internal;

/** What every scene file has for this program. Others can name no type to implement it with. */
public interface SceneFileInside {
  /** Returns the scene file with all that reports, audits and checkpoint files state of it. */
  ParsedScene parsed();
}
