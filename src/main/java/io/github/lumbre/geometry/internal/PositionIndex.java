package io.github.lumbre.geometry.internal;

import java.util.Arrays;

/** Numbers distinct positions in order of occurrence. Mutable. */
public final class PositionIndex {
  private static final int FREE = -1;

  /** Random per run, so that no file can be crafted to cause hash collisions. */
  private final long salt = System.nanoTime() * 0x9E3779B97F4A7C15L | 1;

  private double[] positions = new double[3 * 8];
  private int[] slots = freeSlots(32);
  private int count;

  public PositionIndex() {}

  /** Returns the number of a finite position; assigns the next one at its first occurrence. */
  public int number(double x, double y, double z) {
    // The sum with 0 replaces -0 by 0.
    return find(x + 0.0, y + 0.0, z + 0.0);
  }

  private int find(double x, double y, double z) {
    int slot = slot(x, y, z);
    if (slots[slot] != FREE) {
      return slots[slot];
    }
    if (3 * count == positions.length) {
      positions = Arrays.copyOf(positions, Math.multiplyExact(2, positions.length));
    }
    positions[3 * count] = x;
    positions[3 * count + 1] = y;
    positions[3 * count + 2] = z;
    slots[slot] = count;
    if (3L * ++count > slots.length) {
      growSlots();
    }
    return count - 1;
  }

  /** Returns the slot of the open-addressing hash table that holds the position, or is free. */
  private int slot(double x, double y, double z) {
    long hash = mixed(Double.doubleToRawLongBits(x) ^ salt);
    hash = mixed(hash ^ Double.doubleToRawLongBits(y));
    hash = mixed(hash ^ Double.doubleToRawLongBits(z));
    int mask = slots.length - 1;
    int slot = (int) hash & mask;
    while (slots[slot] != FREE && !isAt(slots[slot], x, y, z)) {
      slot = slot + 1 & mask;
    }
    return slot;
  }

  /** Returns well-mixed bits (Stafford 2011, variant 13). */
  private static long mixed(long bits) {
    long z = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
    z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
    return z ^ z >>> 31;
  }

  private boolean isAt(int number, double x, double y, double z) {
    return positions[3 * number] == x
        && positions[3 * number + 1] == y
        && positions[3 * number + 2] == z;
  }

  private void growSlots() {
    slots = freeSlots(Math.multiplyExact(2, slots.length));
    for (int i = 0; i < count; i++) {
      slots[slot(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2])] = i;
    }
  }

  private static int[] freeSlots(int length) {
    int[] slots = new int[length];
    Arrays.fill(slots, FREE);
    return slots;
  }

  /** Returns three coordinates per position, in the order of their numbers. */
  public double[] positions() {
    return Arrays.copyOf(positions, 3 * count);
  }
}
