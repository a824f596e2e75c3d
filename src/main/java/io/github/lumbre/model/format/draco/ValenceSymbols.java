package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * Symbols in one list for each number of faces that the next vertex has so far. Mutable.
 *
 * <p>Source: M. Isenburg and J. Snoeyink, Early-Split Coding of Triangle Mesh Connectivity, 2006,
 * as the Draco specification uses it.
 */
final class ValenceSymbols implements Symbols {
  private static final int MIN_VALENCE = 2;
  private static final int MAX_VALENCE = 7;
  private static final int[] NO_SYMBOLS = {};

  private final DracoInput input;
  private final int[] valences;
  private final int[][] lists = new int[MAX_VALENCE - MIN_VALENCE + 1][];
  private final int[] left = new int[lists.length];
  private int context = -1;
  private int last = END;

  private ValenceSymbols(DracoInput input, int vertices) throws ModelFormatException {
    this.input = input;
    valences = input.integers(vertices);
  }

  /**
   * Reads all symbols.
   *
   * @param count the largest number of symbols
   * @param vertices the largest number of vertices
   */
  static ValenceSymbols read(DracoInput input, int count, int vertices)
      throws ModelFormatException {
    ValenceSymbols symbols = new ValenceSymbols(input, vertices);
    int more = count;
    for (int i = 0; i < symbols.lists.length; i++) {
      int length = input.count("symbols", more);
      more -= length;
      int[] list = length == 0 ? NO_SYMBOLS : input.integers(length);
      SymbolDecoder.decode(input, 1, list);
      symbols.lists[i] = list;
      symbols.left[i] = length;
    }
    return symbols;
  }

  @Override
  public int next() throws ModelFormatException {
    if (context >= 0) {
      int[] list = lists[context];
      if (left[context] == 0) {
        throw input.malformed("expected another symbol than the last, found none");
      }
      left[context]--;
      last = list[left[context]];
      if (last > END) {
        throw input.malformed("expected a symbol from 0 to 4, found " + last);
      }
    }
    return last;
  }

  @Override
  public void added(int corner, OpenMesh mesh) {
    int tip = mesh.vertex(corner);
    int next = mesh.vertex(corner + 1);
    int previous = mesh.vertex(corner + 2);
    valences[tip] += last == END ? 2 : last == LEFT || last == RIGHT ? 1 : 0;
    valences[next] += last == END || last == LEFT ? 2 : 1;
    valences[previous] += last == END || last == RIGHT ? 2 : 1;
    context = Math.max(MIN_VALENCE, Math.min(MAX_VALENCE, valences[next])) - MIN_VALENCE;
  }

  @Override
  public void merged(int from, int to) {
    valences[to] += valences[from];
  }
}
