package io.github.lumbre.model.format;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelLimits;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The parts of a ZIP archive by its central directory (APPNOTE 6.3, sections 4.3.12 to 4.3.16, with
 * 64-bit sizes). Nothing is inflated before it is used. Names have no regard to case, as the Open
 * Packaging Conventions demand, and as file systems have none where many archives are made.
 * Mutable: it counts the bytes of what is read.
 */
public final class ZipParts implements ModelFolder {
  /** The most entries of an archive. */
  static final int MAX_ENTRIES = 10_000;

  /** All that is inflated has at most this many times the bytes of the archive. */
  static final long MAX_RATIO = 200;

  /** Small archives may exceed the ratio. */
  private static final long SLACK = 1 << 20;

  private static final int END = 0x06054b50;
  private static final int END_BYTES = 22;
  private static final int LONGEST_COMMENT = 0xffff;
  private static final int LOCATOR_64 = 0x07064b50;
  private static final int LOCATOR_64_BYTES = 20;
  private static final int END_64 = 0x06064b50;
  private static final int END_64_BYTES = 56;
  private static final int ENTRY = 0x02014b50;
  private static final int ENTRY_BYTES = 46;
  private static final int LOCAL = 0x04034b50;
  private static final int LOCAL_BYTES = 30;
  private static final int SIZES_64 = 1;
  private static final int ENCRYPTED = 1;
  private static final int STORED = 0;
  private static final int DEFLATED = 8;

  /** Stands in fields of 32 bits for a number in 64 bits elsewhere. */
  private static final long ELSEWHERE = 0xffffffffL;

  /**
   * An entry of the central directory.
   *
   * @param size the claimed number of bytes after inflating
   */
  private record Entry(
      String name, int flags, int method, long crc, long compressed, long size, long offset) {}

  private final ByteBuffer file;
  private final Limits limits;
  private final Map<String, Entry> entries = new HashMap<>();
  private long read;

  private ZipParts(byte[] bytes, Limits limits) {
    file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    this.limits = limits;
  }

  /**
   * Returns the parts of an archive.
   *
   * @throws ModelFormatException if its directory is damaged or too long, or a name leaves it
   */
  public static ZipParts of(byte[] bytes, Limits limits) throws ModelFormatException {
    ZipParts parts = new ZipParts(bytes, limits);
    parts.readDirectory();
    return parts;
  }

  private void readDirectory() throws ModelFormatException {
    int end = endOfDirectory();
    long count = file.getShort(end + 10) & 0xffff;
    long offset = file.getInt(end + 16) & ELSEWHERE;
    int locator = end - LOCATOR_64_BYTES;
    if (locator >= 0 && file.getInt(locator) == LOCATOR_64) {
      int end64 = checked(file.getLong(locator + 8), END_64_BYTES, END_64);
      count = file.getLong(end64 + 32);
      offset = file.getLong(end64 + 48);
    }
    ModelLimits.require("", "entries in the archive", MAX_ENTRIES, count);
    for (long i = 0; i < count; i++) {
      int at = checked(offset, ENTRY_BYTES, ENTRY);
      int nameLength = file.getShort(at + 28) & 0xffff;
      int extraLength = file.getShort(at + 30) & 0xffff;
      int extra = at + ENTRY_BYTES + nameLength;
      offset = (long) extra + extraLength + (file.getShort(at + 32) & 0xffff);
      checkRange(offset, 0);
      add(entry(at, text(at + ENTRY_BYTES, nameLength), extra, extra + extraLength));
    }
  }

  private int endOfDirectory() throws ModelFormatException {
    int first = Math.max(0, file.limit() - END_BYTES - LONGEST_COMMENT);
    for (int at = file.limit() - END_BYTES; at >= first; at--) {
      if (file.getInt(at) == END) {
        return at;
      }
    }
    throw malformed("", "expected a ZIP archive, found no directory at its end");
  }

  /** Returns an offset at which a record of a kind begins. */
  private int checked(long offset, int bytes, int kind) throws ModelFormatException {
    checkRange(offset, bytes);
    if (file.getInt((int) offset) != kind) {
      throw malformed("byte " + offset, "expected a record of the archive, found another one");
    }
    return (int) offset;
  }

  private void checkRange(long offset, long bytes) throws ModelFormatException {
    if (offset < 0 || bytes < 0 || offset > file.limit() - bytes) {
      throw malformed(
          "",
          "expected an archive with %s bytes at offset %s, found one of %s"
              .formatted(bytes, offset, file.limit()));
    }
  }

  private String text(int at, int length) {
    return new String(file.array(), at, length, StandardCharsets.UTF_8);
  }

  private Entry entry(int at, String name, int extra, int extraEnd) throws ModelFormatException {
    long size = file.getInt(at + 24) & ELSEWHERE;
    long compressed = file.getInt(at + 20) & ELSEWHERE;
    long offset = file.getInt(at + 42) & ELSEWHERE;
    int long64 = sizes64(extra, extraEnd);
    int end64 = long64 == 0 ? 0 : Math.min(extraEnd, long64 + (file.getShort(long64 - 2) & 0xffff));
    if (size == ELSEWHERE && long64 + 8 <= end64) {
      size = file.getLong(long64);
      long64 += 8;
    }
    if (compressed == ELSEWHERE && long64 + 8 <= end64) {
      compressed = file.getLong(long64);
      long64 += 8;
    }
    if (offset == ELSEWHERE && long64 + 8 <= end64) {
      offset = file.getLong(long64);
    }
    return new Entry(
        name,
        file.getShort(at + 8),
        file.getShort(at + 10),
        file.getInt(at + 16) & ELSEWHERE,
        compressed,
        size,
        offset);
  }

  /** Returns the offset of the 64-bit sizes; 0 if there are none. */
  private int sizes64(int from, int to) {
    int at = from;
    while (at + 4 <= to) {
      if (file.getShort(at) == SIZES_64) {
        return at + 4;
      }
      at += 4 + (file.getShort(at + 2) & 0xffff);
    }
    return 0;
  }

  private void add(Entry entry) throws ModelFormatException {
    String name = entry.name.replace('\\', '/');
    boolean isAbsolute = name.matches("(?s)(/|[A-Za-z]:).*");
    if (isAbsolute || List.of(name.split("/")).contains("..")) {
      throw malformed(
          "", "expected names inside the archive, found " + PrintableText.quoted(entry.name));
    }
    if (entries.put(key(name), entry) != null) {
      throw malformed(
          "", "expected one entry " + PrintableText.quoted(entry.name) + ", found several");
    }
  }

  /** Returns the key of a part's name, with or without a slash at its beginning. */
  private static String key(String name) {
    return (name.startsWith("/") ? name.substring(1) : name).toLowerCase(Locale.ROOT);
  }

  /** Returns the names of all entries as in the archive. */
  public Collection<String> names() {
    return entries.values().stream().map(Entry::name).toList();
  }

  public boolean has(String name) {
    return entries.containsKey(key(name));
  }

  /**
   * Returns the bytes of a part one after the other.
   *
   * @param location of the reference to it, for messages
   * @throws ModelFormatException if it is missing, or its size exceeds a limit
   */
  public ZipInput open(String name, String location) throws ModelFormatException {
    Entry entry =
        Optional.ofNullable(entries.get(key(name)))
            .orElseThrow(
                () ->
                    Kind.ASSET.at(
                        location,
                        "expected a part of the archive, found no " + PrintableText.quoted(name)));
    String place = PrintableText.shortened(entry.name);
    if ((entry.flags & ENCRYPTED) != 0 || entry.method != STORED && entry.method != DEFLATED) {
      throw Kind.UNSUPPORTED.at(
          place,
          "expected a part that is stored or deflated, found "
              + ((entry.flags & ENCRYPTED) != 0 ? "an encrypted one" : "method " + entry.method));
    }
    int local = checked(entry.offset, LOCAL_BYTES, LOCAL);
    long from =
        (long) local
            + LOCAL_BYTES
            + (file.getShort(local + 26) & 0xffff)
            + (file.getShort(local + 28) & 0xffff);
    checkRange(from, entry.compressed);
    if (entry.size < 0 || entry.method == STORED && entry.size != entry.compressed) {
      throw malformed(place, "expected a size of " + entry.compressed + ", found " + entry.size);
    }
    count(place, entry.size);
    return new ZipInput(
        place,
        entry.method == DEFLATED,
        ByteBuffer.wrap(file.array(), (int) from, (int) entry.compressed),
        entry.size,
        entry.crc);
  }

  /** Counts the bytes of a part, so that all parts together cost at most what an archive may. */
  private void count(String place, long size) throws ModelFormatException {
    read = read + size < 0 ? Long.MAX_VALUE : read + size;
    ModelLimits.require(
        place,
        "inflated bytes of an archive of " + file.limit() + " bytes",
        SLACK + MAX_RATIO * file.limit(),
        read);
    ModelLimits.require(place, "bytes in all files", limits.bytes(), read);
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException {
    try (ZipInput in = open(name, location)) {
      ModelLimits.requireMemory(location, in.size(), limits);
      ModelLimits.require(location, "bytes in a part", Integer.MAX_VALUE - 8, in.size());
      byte[] bytes = new byte[(int) in.size()];
      int filled = 0;
      int more;
      while ((more = in.read(bytes, filled)) > 0) {
        filled += more;
      }
      return bytes;
    }
  }

  private static ModelFormatException malformed(String location, String message) {
    return Kind.MALFORMED.at(location, message);
  }
}
