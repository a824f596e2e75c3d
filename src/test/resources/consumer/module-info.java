/** A program that embeds the renderer. */
module consumer {
  requires io.github.lumbre;
}
