/**
 * The program that makes the models of the example scenes, with their textures and normal maps.
 *
 * <p>Start at {@link generator.GenerateModels}. A figure such as {@link generator.Frog} is a {@link
 * generator.Sculpture} of solids, each a signed distance ({@link generator.Sdf}) with a {@link
 * generator.Paint}. {@link generator.Workshop} turns it into files: {@link generator.Mesher} finds
 * the surface, {@link generator.Decimator} thins it out, {@link generator.Atlas} unwraps it, and
 * {@link generator.Baker} paints the colours and the relief into the unwrapped square. Glasses are
 * turned on a {@link generator.Lathe}; the wheels of {@link generator.Clockwork} are {@link
 * generator.Gears}.
 *
 * <p>Space is left-handed: +x right, +y up, +z forward; figures stand on y = 0 and face -z. Lengths
 * are metres. Only operations with the same result on every machine are used, so that every run
 * writes the same models.
 */
package generator;
