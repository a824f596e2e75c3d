package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;
import static io.github.lumbre.model.format.draco.CornerTable.next;
import static io.github.lumbre.model.format.draco.CornerTable.previous;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Rebuilds triangles from the symbols of an edgebreaker traversal, the last one of the encoder
 * first. Each symbol adds a face to the open edge that is opposite to the active corner. Mutable.
 */
final class EdgebreakerConnectivity {
  private static final int STANDARD = 0;
  private static final int VALENCE = 2;

  /** Three vertices per face, and one more per split, fit into an array. */
  private static final int MAX_FACES = (Integer.MAX_VALUE - 8) / 4;

  /** Heap bytes of an entry of a hash map. */
  private static final long BYTES_PER_SPLIT = 80;

  /** Symbols between two checks for an interrupt, minus 1. */
  private static final int INTERRUPT_MASK = (1 << 14) - 1;

  private final DracoInput input;
  private final int symbolCount;
  private final OpenMesh mesh;
  private final TopologySplits splits;
  private final Symbols symbols;
  private final RansBitDecoder startFaces;
  private final List<RansBitDecoder> seamBits = new ArrayList<>();
  private final IntStack active;

  /** The active corners that wait for a symbol of the decoder. */
  private final Map<Integer, Integer> waiting = new HashMap<>();

  private EdgebreakerConnectivity(DracoInput input, DracoLimits limits)
      throws ModelFormatException {
    this.input = input;
    int traversal = input.unsignedByte();
    if (traversal != STANDARD && traversal != VALENCE) {
      throw input.unsupported("expected standard (0) or valence (2) traversal, found " + traversal);
    }
    long maxVertices = 3 * Math.min(limits.faces(), MAX_FACES);
    int vertices = input.count("vertices", maxVertices);
    int faces = input.count("faces", Math.min(limits.faces(), MAX_FACES));
    if (vertices > 3L * faces) {
      throw input.malformed(
          "expected at most three vertices per face, found %s of %s faces"
              .formatted(vertices, faces));
    }
    int attributes = input.unsignedByte();
    symbolCount = input.count("symbols", faces);
    int splitSymbols = input.count("split symbols", symbolCount);
    int allVertices = vertices + splitSymbols;
    splits = TopologySplits.read(input, symbolCount);
    Optional<Symbols> standard =
        traversal == STANDARD
            ? Optional.of(Symbols.standard(input, symbolCount))
            : Optional.empty();
    startFaces = RansBitDecoder.read(input);
    for (int i = 0; i < attributes; i++) {
      seamBits.add(RansBitDecoder.read(input));
    }
    symbols =
        standard.isPresent()
            ? standard.get()
            : ValenceSymbols.read(input, symbolCount, allVertices);
    mesh = new OpenMesh(input, faces, allVertices, splitSymbols);
    active = new IntStack(input);
  }

  /** Reads the connectivity of a mesh. */
  static Connectivity decode(DracoInput input, DracoLimits limits) throws ModelFormatException {
    return new EdgebreakerConnectivity(input, limits).decode();
  }

  private Connectivity decode() throws ModelFormatException {
    for (int i = 0; i < symbolCount; i++) {
      if ((i & INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      addFace(i);
    }
    addStartFaces();
    CornerTable table = mesh.table(seamBits.isEmpty());
    if (seamBits.isEmpty()) {
      return Connectivity.of(table);
    }
    List<CornerTable> seams = new ArrayList<>();
    for (RansBitDecoder bits : seamBits) {
      Interrupts.check();
      seams.add(table.cut(seams(table, bits), input));
    }
    return Connectivity.of(table, seams, input);
  }

  private void addFace(int index) throws ModelFormatException {
    int corner = 3 * index;
    int symbol = symbols.next();
    switch (symbol) {
      case Symbols.CENTER -> addCenter(corner, active());
      case Symbols.SPLIT -> addSplit(corner, active(), index);
      case Symbols.LEFT -> addSide(active(), corner + 1, corner + 2, corner);
      case Symbols.RIGHT -> addSide(active(), corner + 2, corner, corner + 1);
      default -> {
        mesh.addVertex(corner);
        mesh.addVertex(corner + 1);
        mesh.addVertex(corner + 2);
      }
    }
    active.push(corner);
    symbols.added(corner, mesh);
    if (symbol >= Symbols.LEFT) {
      noteSplits(corner, index);
    }
  }

  /** Removes the active corner, and returns it. */
  private int active() throws ModelFormatException {
    if (active.isEmpty()) {
      throw input.malformed("expected a symbol that begins a part of the mesh, found another");
    }
    return active.pop();
  }

  /** Adds a face between the active edge and the open edge that follows, and closes a vertex. */
  private void addCenter(int corner, int a) throws ModelFormatException {
    int closed = mesh.vertex(next(a));
    int b = mesh.acrossNext(closed);
    mesh.join(a, corner + 1);
    mesh.join(b, corner + 2);
    mesh.add(corner, closed);
    mesh.add(corner + 1, mesh.vertex(next(b)));
    mesh.addFirst(corner + 2, mesh.vertex(previous(a)));
  }

  /**
   * Adds a face with a new vertex.
   *
   * @param a the active corner
   * @param tip the corner of the face at the new vertex
   * @param right its corner at the vertex before a
   * @param left its corner at the vertex after a
   */
  private void addSide(int a, int tip, int right, int left) throws ModelFormatException {
    mesh.join(tip, a);
    mesh.addVertex(tip);
    mesh.addFirst(right, mesh.vertex(previous(a)));
    mesh.add(left, mesh.vertex(next(a)));
  }

  /** Adds a face that joins two open edges at a vertex, which both parts of the mesh have. */
  private void addSplit(int corner, int b, int index) throws ModelFormatException {
    Integer split = waiting.get(index);
    int a = split == null ? active() : split;
    mesh.join(a, corner + 2);
    mesh.join(b, corner + 1);
    int kept = mesh.vertex(previous(a));
    mesh.add(corner, kept);
    mesh.add(corner + 1, mesh.vertex(next(a)));
    mesh.addFirst(corner + 2, mesh.vertex(previous(b)));
    int gone = mesh.vertex(next(b));
    symbols.merged(gone, kept);
    mesh.merge(gone, kept);
  }

  /** Notes the edges of a face that are active again when a later symbol is read. */
  private void noteSplits(int corner, int index) throws ModelFormatException {
    while (splits.isAt(symbolCount - index - 1)) {
      int edge = splits.isRight() ? next(corner) : previous(corner);
      input.allocate(BYTES_PER_SPLIT);
      waiting.put(symbolCount - splits.take() - 1, edge);
    }
  }

  /** Adds the faces with which the encoder began inside of the parts of the mesh. */
  private void addStartFaces() throws ModelFormatException {
    int faces = symbolCount;
    while (!active.isEmpty()) {
      int a = active.pop();
      if (startFaces.next()) {
        if (faces == mesh.faceCount()) {
          throw input.malformed("expected " + faces + " faces, found more");
        }
        addStartFace(3 * faces++, a);
      }
    }
    if (faces != mesh.faceCount()) {
      throw input.malformed("expected " + mesh.faceCount() + " faces, found " + faces);
    }
  }

  private void addStartFace(int corner, int a) throws ModelFormatException {
    int end = mesh.vertex(next(a));
    int b = mesh.acrossNext(end);
    int tip = mesh.vertex(next(b));
    int c = mesh.acrossNext(tip);
    mesh.join(corner, a);
    mesh.join(corner + 1, b);
    mesh.join(corner + 2, c);
    mesh.add(corner, tip);
    mesh.add(corner + 1, mesh.vertex(next(c)));
    mesh.add(corner + 2, end);
  }

  /** Returns the corners opposite to edges at which the faces of an attribute are not connected. */
  private BitSet seams(CornerTable table, RansBitDecoder bits) throws ModelFormatException {
    int[] opposites = table.opposites();
    input.allocate(opposites.length / Byte.SIZE);
    BitSet seams = new BitSet(opposites.length);
    for (int corner = 0; corner < opposites.length; corner++) {
      int opposite = opposites[corner];
      if (opposite != NONE && opposite / 3 >= corner / 3 && bits.next()) {
        seams.set(corner);
        seams.set(opposite);
      }
    }
    return seams;
  }
}
