package io.github.lumbre.cli;

import io.github.lumbre.base.Release;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.lab.trade.Knob;
import io.github.lumbre.lab.trade.TradeBudget;
import io.github.lumbre.lab.trade.TradePage;
import io.github.lumbre.lab.trade.TradePlan;
import io.github.lumbre.lab.trade.TradeResult;
import io.github.lumbre.lab.trade.TradeScene;
import io.github.lumbre.lab.trade.TradeStudy;
import io.github.lumbre.lab.trade.TradeSweep;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleFunction;

/** The study of one scene: reads it with all compared settings, and measures. Single use. */
final class TradeRun {
  /** The share of the time for each pilot render; the first of the two warms up the JVM. */
  private static final double PILOT_SHARE = .008;

  private static final double LEAST_PILOT_SECONDS = .1;
  private static final double MOST_PILOT_SECONDS = 1;

  private final SceneOptions options;
  private final KernelFlag kernel;
  private final TradeBudget budget;
  private final int threads;
  private final Messages messages;
  private final Messages quiet = new Messages(new PrintWriter(Writer.nullWriter()));
  private final Map<String, String> facts = new LinkedHashMap<>();
  private final double start = System.nanoTime() * 1e-9;
  private SceneFile file;
  private double rate;
  private TradeResult result;

  /**
   * @param threads number of threads; 0 means one per processor
   */
  TradeRun(
      SceneOptions options, KernelFlag kernel, TradeBudget budget, int threads, Messages messages) {
    this.options = options;
    this.kernel = kernel;
    this.budget = budget;
    this.threads = threads;
    this.messages = messages;
  }

  /** Measures all settings and prints the progress. */
  TradeResult run(Set<Knob> knobs)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    SceneParser parser = kernel.over(options.parser()).inMode(Mode.PATH);
    file = options.load(parser, messages);
    pilot();
    rate = pilot();
    RenderSettings settings = framed(file);
    TradeSweep sweep = new TradeSweep(counted(file, parser), settings, knobs);
    if (knobs.contains(Knob.FILTER)) {
      addFilters(sweep, parser);
    }
    if (knobs.contains(Knob.MODE)) {
      SceneParser ofRays = kernel.over(options.parser()).inMode(Mode.RAY);
      SceneFile rays = options.load(ofRays, quiet);
      sweep.addRays(counted(rays, ofRays), framed(rays));
    }
    int count = sweep.settings(TradeBudget.LARGEST).size();
    double before = spent();
    DoubleFunction<TradePlan> planner = r -> budget.plan(r, before, count, settings);
    result = new TradeStudy(sweep, planner, messages::line).run(rate);
    tell(settings);
    return result;
  }

  /**
   * Returns the baseline's rate in samples per second, measured by a pilot render. The first pilot
   * measures mostly the JVM's warm-up.
   */
  private double pilot() throws InterruptedException {
    RenderSettings usual = TradeSweep.usual(file.settings()).toBuilder().threads(threads).build();
    double wanted =
        Math.max(LEAST_PILOT_SECONDS, Math.min(PILOT_SHARE * budget.seconds(), MOST_PILOT_SECONDS));
    return SampleBudget.rate(file.scene(), usual, wanted);
  }

  private double spent() {
    return System.nanoTime() * 1e-9 - start;
  }

  private RenderSettings framed(SceneFile read) {
    return budget.framed(read.settings(), rate).toBuilder().threads(threads).build();
  }

  /** Returns a scene together with a copy that counts node visits and texture lookups. */
  private TradeScene counted(SceneFile read, SceneParser parser)
      throws SceneFormatException, TaskException, IOException {
    LongAdder nodes = new LongAdder();
    LongAdder lookUps = new LongAdder();
    SceneFile again = options.load(parser.counting(lookUps), quiet);
    return new TradeScene(read.scene(), again.scene().counting(nodes), nodes, lookUps);
  }

  /** Adds the texture filters that change the picture. */
  private void addFilters(TradeSweep sweep, SceneParser parser)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    for (Filter filter : Filter.values()) {
      SceneParser filtering = parser.interpolatingTextures(filter == Filter.BILINEAR);
      SceneFile read = options.load(filtering, quiet);
      if (!Arrays.equals(look(read), look(file))) {
        sweep.addFilter(SettingType.nameOf(filter), counted(read, filtering));
      }
    }
  }

  private float[] look(SceneFile read) throws InterruptedException {
    RenderSettings once = framed(read).toBuilder().samples(1).build();
    return new PictureRenderer(once).render(read.scene()).rgb();
  }

  private void tell(RenderSettings settings) {
    facts.put("scene", Messages.printable(String.valueOf(options.scene().getFileName())));
    facts.put("scene hash", file.hash());
    facts.put("size", settings.width() + "x" + settings.height());
    facts.put("seeds", result.seeds() + " for each setting, numbered from 1");
    facts.put("machine", Machine.here().line());
    facts.put("threads", threads == 0 ? "one per processor" : String.valueOf(threads));
    facts.put("load", String.format(Locale.ROOT, "%.1f", Machine.here().loadBefore()));
    facts.put("version", Release.number());
    facts.put("took", Math.round(spent()) + " s");
  }

  /** Adds the command line to the facts about the study. */
  void tellCommand(String command) {
    facts.put("command", command);
  }

  /** Returns the facts about the study by name; call after {@link #run}. */
  Map<String, String> facts() {
    return facts;
  }

  /** Returns the page; call after {@link #run}. */
  String page() {
    return TradePage.of(facts.get("scene"), facts, result);
  }
}
