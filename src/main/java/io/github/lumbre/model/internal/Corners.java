package io.github.lumbre.model.internal;

import java.util.Arrays;

/**
 * Numbers a mesh's distinct corners in order of occurrence: three indices each, usually of a
 * position, of texture coordinates and of a normal. Mutable.
 */
public final class Corners {
  private static final int FREE = -1;

  /** Random per run, so that no file can be crafted to cause hash collisions. */
  private final long salt = System.nanoTime() * 0x9E3779B97F4A7C15L | 1;

  private int[] corners = new int[3 * 16];
  private int[] slots = freeSlots(64);
  private int count;

  /** Returns the number of a corner; assigns the next one at its first occurrence. */
  public int number(int position, int uv, int normal) {
    int slot = slot(position, uv, normal);
    if (slots[slot] != FREE) {
      return slots[slot];
    }
    if (3 * count == corners.length) {
      corners = Arrays.copyOf(corners, Math.multiplyExact(2, corners.length));
    }
    corners[3 * count] = position;
    corners[3 * count + 1] = uv;
    corners[3 * count + 2] = normal;
    slots[slot] = count;
    if (4L * ++count > slots.length) {
      growSlots();
    }
    return count - 1;
  }

  /** Returns the slot of the open-addressing hash table that holds the corner, or is free. */
  private int slot(int position, int uv, int normal) {
    int mask = slots.length - 1;
    long hash = (position * salt ^ uv) * salt;
    hash = ((hash ^ hash >>> 32) ^ normal) * salt;
    int slot = (int) (hash >>> 32 ^ hash >>> 15) & mask;
    while (slots[slot] != FREE && !isAt(slots[slot], position, uv, normal)) {
      slot = slot + 1 & mask;
    }
    return slot;
  }

  private boolean isAt(int number, int position, int uv, int normal) {
    return corners[3 * number] == position
        && corners[3 * number + 1] == uv
        && corners[3 * number + 2] == normal;
  }

  private void growSlots() {
    slots = freeSlots(Math.multiplyExact(2, slots.length));
    for (int i = 0; i < count; i++) {
      slots[slot(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2])] = i;
    }
  }

  private static int[] freeSlots(int length) {
    int[] slots = new int[length];
    Arrays.fill(slots, FREE);
    return slots;
  }

  /**
   * Returns the values of all corners, in the order of their numbers.
   *
   * @param list index to use: 0, 1 or 2 for position, texture coordinates or normal
   * @param values the indexed elements, {@code size} numbers each; may be empty
   */
  public double[] gather(int list, double[] values, int size) {
    if (values.length == 0) {
      return values;
    }
    double[] gathered = new double[Math.multiplyExact(size, count)];
    for (int i = 0; i < count; i++) {
      System.arraycopy(values, size * corners[3 * i + list], gathered, size * i, size);
    }
    return gathered;
  }

  /** Returns the values of all corners, as {@link #gather(int, double[], int)} does. */
  public float[] gather(int list, float[] values, int size) {
    float[] gathered = new float[Math.multiplyExact(size, count)];
    for (int i = 0; i < count; i++) {
      System.arraycopy(values, size * corners[3 * i + list], gathered, size * i, size);
    }
    return gathered;
  }
}
