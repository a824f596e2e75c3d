package io.github.lumbre.spark;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import java.io.Serializable;
import java.net.InetAddress;
import java.net.UnknownHostException;
import org.apache.spark.TaskContext;
import org.apache.spark.broadcast.Broadcast;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction1;

/** What an executor does with a unit: renders its samples with one thread. */
final class UnitRenderer extends AbstractFunction1<Iterator<WorkUnit>, UnitResult>
    implements Serializable {
  private static final long serialVersionUID = 1;

  /** The renderers of this executor, of the pictures that render at the same time. */
  private static final KeptRenderers RENDERERS = new KeptRenderers(RenderOnSpark.PICTURES_AT_ONCE);

  private final Broadcast<SceneBundle> bundle;

  UnitRenderer(Broadcast<SceneBundle> bundle) {
    this.bundle = bundle;
  }

  @Override
  public UnitResult apply(Iterator<WorkUnit> units) {
    WorkUnit unit = units.next();
    FilmRenderer whole = renderer();
    long start = System.nanoTime();
    FilmRenderer renderer = whole.in(unit.tile());
    Film film = renderer.newFilm(unit.first());
    try {
      PassResult pass = renderer.addSamples(film, unit.count(), untilKilled());
      if (!pass.complete()) {
        throw new IllegalStateException("stopped: " + unit);
      }
      double seconds = (System.nanoTime() - start) * 1e-9;
      return UnitResult.of(unit, film, pass.statistics(), seconds);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted: " + unit, e);
    }
  }

  private static Progress untilKilled() {
    TaskContext task = TaskContext.get();
    return Progress.NONE.cancelledAlsoIf(() -> task != null && task.isInterrupted());
  }

  private FilmRenderer renderer() {
    SceneBundle sent = bundle.value();
    if (sent.revision() != FilmRenderer.REVISION) {
      throw new IllegalStateException(
          "the executor on "
              + host()
              + " has Lumbre's samples of revision "
              + FilmRenderer.REVISION
              + ", expected the driver's "
              + sent.revision()
              + "; give all executors the same lumbre-spark.jar");
    }
    return RENDERERS.get(sent.identity(), () -> renderer(sent.read()));
  }

  private static FilmRenderer renderer(SceneFile scene) {
    RenderSettings settings = scene.settings().toBuilder().threads(1).adaptive(false).build();
    return new FilmRenderer(settings, scene.scene());
  }

  private static String host() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "an unknown host";
    }
  }
}
