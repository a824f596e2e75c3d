import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Enumeration;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;

/**
 * Raises old class files of a jar to the format of Java 17, for the build. Java keeps no classes of
 * formats before Java 6 in its archives and caches: it would read and verify picocli's classes at
 * each start.
 */
final class UpgradeClasses {
  private static final int OLDEST_ARCHIVED = Opcodes.V1_6;

  private UpgradeClasses() {}

  /**
   * Makes a jar of another one, which is deleted. An existing jar is replaced in one step, because
   * the program may be starting from it.
   *
   * @param args the other jar, which must be on the class path too, because stack maps need the
   *     common superclasses of its classes; and the jar to make
   */
  public static void main(String[] args) throws IOException {
    Path shaded = Path.of(args[0]);
    Path upgraded = Path.of(args[0] + ".upgraded");
    try (ZipFile in = new ZipFile(shaded.toFile());
        ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(upgraded))) {
      for (Enumeration<? extends ZipEntry> e = in.entries(); e.hasMoreElements(); ) {
        copy(e.nextElement(), in, out);
      }
    }
    Files.move(upgraded, Path.of(args[1]), StandardCopyOption.ATOMIC_MOVE);
    Files.delete(shaded);
  }

  private static void copy(ZipEntry entry, ZipFile in, ZipOutputStream out) throws IOException {
    ZipEntry copy = new ZipEntry(entry);
    copy.setCompressedSize(-1);
    out.putNextEntry(copy);
    try (InputStream content = in.getInputStream(entry)) {
      byte[] bytes = content.readAllBytes();
      out.write(entry.getName().endsWith(".class") ? upgraded(bytes) : bytes);
    }
    out.closeEntry();
  }

  private static byte[] upgraded(byte[] bytes) {
    ClassReader reader = new ClassReader(bytes);
    if (reader.readUnsignedShort(6) >= OLDEST_ARCHIVED) {
      return bytes;
    }
    ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_FRAMES);
    ClassVisitor upgrade =
        new ClassVisitor(Opcodes.ASM9, writer) {
          @Override
          public void visit(
              int version,
              int access,
              String name,
              String signature,
              String base,
              String[] interfaces) {
            super.visit(Opcodes.V17, access, name, signature, base, interfaces);
          }
        };
    reader.accept(upgrade, ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }
}
