package generator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/**
 * Writes the models with their textures and normal maps, and the tiling maps. Every run writes the
 * same files. Arguments name the models to write; without any, everything is written.
 */
public final class GenerateModels {
  private final Path models;
  private final Set<String> wanted;

  private GenerateModels(Path models, Set<String> wanted) {
    this.models = models;
    this.wanted = wanted;
  }

  /**
   * Writes to {@code scenes/models} and {@code scenes/textures} of the current folder.
   *
   * @param arguments the names of the models wanted, or none for all
   * @throws IOException if a file cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    Path models = Files.createDirectories(Path.of("scenes", "models"));
    GenerateModels generator = new GenerateModels(models, Set.of(arguments));
    generator.figures();
    generator.furniture();
    if (generator.wants("maps")) {
      TilingMaps.write(Files.createDirectories(Path.of("scenes", "textures")));
    }
  }

  private boolean wants(String name) {
    return wanted.isEmpty() || wanted.contains(name);
  }

  private void figures() throws IOException {
    Workshop workshop = new Workshop(models);
    if (wants("armoured-figure")) {
      workshop.write(
          "armoured-figure",
          "A standing figure in plate armour, 1.8 units tall, facing -z.",
          ArmouredFigure.sculpture(),
          34000,
          .0012);
    }
    if (wants("suited-figure")) {
      workshop.write(
          "suited-figure",
          "A standing figure in a technical suit, 1.8 units tall, facing -z.",
          SuitedFigure.sculpture(),
          34000,
          .0012);
    }
    if (wants("frog")) {
      workshop.write(
          "frog", "A sitting frog, 0.6 units tall, facing -z.", Frog.sculpture(), 24000, .0006);
    }
  }

  private void furniture() throws IOException {
    if (wants("wine-glass")) {
      Tableware.wineGlass()
          .write(models.resolve("wine-glass.obj"), "A wine glass, 0.21 units tall.");
    }
    if (wants("pool-water")) {
      HardLight.water().write(models.resolve("pool-water.obj"), "The surface of a pool.");
    }
    if (wants("lamp-shade")) {
      HardLight.shade().write(models.resolve("lamp-shade.obj"), "A lamp shade, 0.24 units tall.");
    }
    if (wants("tumbler")) {
      Tableware.tumbler().write(models.resolve("tumbler.obj"), "A tumbler, 0.095 units tall.");
    }
    if (wants("lantern")) {
      Lantern.glb().write(models.resolve("lantern.glb"), "A burning oil lantern, 0.42 units tall");
    }
    if (wants("clockwork")) {
      Clockwork.glb()
          .write(models.resolve("clockwork.glb"), "The movement of a clock, 0.35 units wide");
    }
    if (wants("table")) {
      Table.obj().write(models.resolve("table.obj"), "A table, 1.6 x 0.9 units, 0.75 tall.");
    }
  }
}
