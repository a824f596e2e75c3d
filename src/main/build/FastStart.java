import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Prepares the classes of the program's jar for a fast start, for the build:
 *
 * <ul>
 *   <li>Old class files get the format of Java 17. Java keeps no classes of formats before Java 6 in
 *       its archives and caches: it would read and verify picocli's classes at each start.
 *   <li>picocli's default names of negated flags are four regular expressions. They are compiled
 *       once, instead of for each group of flags.
 *   <li>Each lambda and method reference of Lumbre gets a class of its own, which Java archives like
 *       any other. Otherwise Java 17 links them at each start: a thumbnail has about 700, of 0.15 ms
 *       each (docs/measurements/2026-11-start.md).
 *   <li>The denoiser's weights are stored: deflating would leave 92 % of them.
 * </ul>
 */
final class FastStart {
  private static final int OLDEST_ARCHIVED = Opcodes.V1_6;

  private static final String WEIGHTS = ".f16";

  /** The class of the names of negated flags, and its method that makes the default ones. */
  private static final String NEGATION = "picocli/CommandLine$RegexTransformer";

  private static final String DEFAULT_NEGATION = "createDefault";

  private final Map<String, byte[]> files = new LinkedHashMap<>();
  private final Lambdas lambdas = new Lambdas();

  private FastStart() {}

  /**
   * Makes a jar of another one, which is deleted. An existing jar is replaced in one step, because
   * the program may be starting from it.
   *
   * @param args the other jar, which must be on the class path too, because stack maps need the
   *     common superclasses of its classes; and the jar to make
   */
  public static void main(String[] args) throws IOException {
    Path shaded = Path.of(args[0]);
    Path prepared = Path.of(args[0] + ".prepared");
    new FastStart().prepare(shaded, prepared);
    Files.move(prepared, Path.of(args[1]), StandardCopyOption.ATOMIC_MOVE);
    Files.delete(shaded);
  }

  private void prepare(Path from, Path to) throws IOException {
    FileTime time;
    try (ZipFile in = new ZipFile(from.toFile())) {
      List<? extends ZipEntry> entries = Collections.list(in.entries());
      time = entries.get(0).getLastModifiedTime();
      for (ZipEntry entry : entries) {
        byte[] content = in.getInputStream(entry).readAllBytes();
        files.put(entry.getName(), prepared(entry.getName(), content));
      }
    }
    lambdas.members.forEach(
        (host, members) ->
            files.computeIfPresent(host + ".class", (name, old) -> joined(old, members)));
    lambdas.classes.forEach((name, content) -> files.put(name + ".class", content));
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(to))) {
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        ZipEntry entry = new ZipEntry(file.getKey()).setLastModifiedTime(time);
        if (file.getKey().endsWith(WEIGHTS)) {
          store(entry, file.getValue());
        }
        out.putNextEntry(entry);
        out.write(file.getValue());
        out.closeEntry();
      }
    }
  }

  private static void store(ZipEntry entry, byte[] content) {
    CRC32 sum = new CRC32();
    sum.update(content);
    entry.setMethod(ZipEntry.STORED);
    entry.setSize(content.length);
    entry.setCrc(sum.getValue());
  }

  private byte[] prepared(String name, byte[] content) {
    if (!name.endsWith(".class")) {
      return content;
    }
    ClassReader reader = new ClassReader(content);
    if (reader.readUnsignedShort(6) < OLDEST_ARCHIVED) {
      return upgraded(reader);
    }
    return name.startsWith("io/github/lumbre/") ? lambdas.replaced(reader) : content;
  }

  private static byte[] upgraded(ClassReader reader) {
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
    boolean isNegation = reader.getClassName().equals(NEGATION);
    reader.accept(
        isNegation ? new KeptResult(upgrade, NEGATION, DEFAULT_NEGATION) : upgrade,
        ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }

  /** Lets some classes call the private methods of a class. */
  private static byte[] joined(byte[] host, List<String> members) {
    ClassWriter writer = new ClassWriter(0);
    ClassVisitor join =
        new ClassVisitor(Opcodes.ASM9, writer) {
          @Override
          public void visitEnd() {
            members.forEach(this::visitNestMember);
            super.visitEnd();
          }
        };
    new ClassReader(host).accept(join, 0);
    return writer.toByteArray();
  }
}

/** Calls a static method without arguments once, when its class is initialized. */
final class KeptResult extends ClassVisitor {
  private static final String FIELD = "KEPT";

  private final String owner;
  private final String method;
  private String descriptor;

  KeptResult(ClassVisitor next, String owner, String method) {
    super(Opcodes.ASM9, next);
    this.owner = owner;
    this.method = method;
  }

  private String first() {
    return method + "First";
  }

  @Override
  public MethodVisitor visitMethod(
      int access, String name, String type, String signature, String[] exceptions) {
    if (!name.equals(method)) {
      return super.visitMethod(access, name, type, signature, exceptions);
    }
    descriptor = type;
    return super.visitMethod(access, first(), type, signature, exceptions);
  }

  @Override
  public void visitEnd() {
    if (descriptor == null) {
      throw new IllegalArgumentException(owner + ": expected a method " + method);
    }
    String type = Type.getReturnType(descriptor).getDescriptor();
    int constant = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL;
    visitField(constant, FIELD, type, null, null).visitEnd();
    MethodVisitor code = super.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
    code.visitCode();
    code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, first(), descriptor, false);
    code.visitFieldInsn(Opcodes.PUTSTATIC, owner, FIELD, type);
    code.visitInsn(Opcodes.RETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
    int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC;
    code = super.visitMethod(access, method, descriptor, null, null);
    code.visitCode();
    code.visitFieldInsn(Opcodes.GETSTATIC, owner, FIELD, type);
    code.visitInsn(Opcodes.ARETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
    super.visitEnd();
  }
}

/** The lambdas of classes, as classes. */
final class Lambdas {
  private static final String FACTORY = "java/lang/invoke/LambdaMetafactory";

  /** The made classes, by internal name. */
  final Map<String, byte[]> classes = new LinkedHashMap<>();

  /** The made classes by the class whose nest they belong to. */
  final Map<String, List<String>> members = new LinkedHashMap<>();

  /** Returns a class without lambdas but those that the plain factory does not make. */
  byte[] replaced(ClassReader reader) {
    ClassWriter writer = new ClassWriter(0);
    ClassVisitor replace =
        new ClassVisitor(Opcodes.ASM9, writer) {
          private String host = reader.getClassName();
          private int count;

          @Override
          public void visitNestHost(String name) {
            host = name;
            super.visitNestHost(name);
          }

          @Override
          public MethodVisitor visitMethod(
              int access, String name, String descriptor, String signature, String[] exceptions) {
            MethodVisitor next =
                super.visitMethod(access, name, descriptor, signature, exceptions);
            return new MethodVisitor(Opcodes.ASM9, next) {
              @Override
              public void visitInvokeDynamicInsn(
                  String method, String site, Handle bootstrap, Object... arguments) {
                if (!bootstrap.getOwner().equals(FACTORY)
                    || !bootstrap.getName().equals("metafactory")) {
                  super.visitInvokeDynamicInsn(method, site, bootstrap, arguments);
                  return;
                }
                String made = reader.getClassName() + "$$" + count++;
                members.computeIfAbsent(host, key -> new ArrayList<>()).add(made);
                LambdaClass lambda = new LambdaClass(made, host, Type.getMethodType(site));
                lambda.addMethod(
                    method, (Type) arguments[0], (Handle) arguments[1], (Type) arguments[2]);
                classes.put(made, lambda.bytes());
                lambda.writeInstance(this);
              }
            };
          }
        };
    reader.accept(replace, 0);
    return writer.toByteArray();
  }
}

/**
 * The class of a lambda: what it captures, and the method that calls the one with its body. It does
 * what that of {@code java.lang.invoke.LambdaMetafactory} does.
 */
final class LambdaClass {
  private static final String OBJECT = "java/lang/Object";
  private static final String INSTANCE = "INSTANCE";

  private static final Map<Type, Type> WRAPPERS =
      Map.of(
          Type.BOOLEAN_TYPE, Type.getType(Boolean.class),
          Type.BYTE_TYPE, Type.getType(Byte.class),
          Type.SHORT_TYPE, Type.getType(Short.class),
          Type.CHAR_TYPE, Type.getType(Character.class),
          Type.INT_TYPE, Type.getType(Integer.class),
          Type.LONG_TYPE, Type.getType(Long.class),
          Type.FLOAT_TYPE, Type.getType(Float.class),
          Type.DOUBLE_TYPE, Type.getType(Double.class));

  private final ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
  private final String name;
  private final Type site;
  private final Type[] captured;

  /**
   * @param site takes what is captured, and returns the interface
   */
  LambdaClass(String name, String host, Type site) {
    this.name = name;
    this.site = site;
    captured = site.getArgumentTypes();
    int access = Opcodes.ACC_FINAL | Opcodes.ACC_SUPER | Opcodes.ACC_SYNTHETIC;
    String[] interfaces = {site.getReturnType().getInternalName()};
    writer.visit(Opcodes.V17, access, name, null, OBJECT, interfaces);
    writer.visitNestHost(host);
    addConstructor();
    if (captured.length == 0) {
      addInstance();
    } else {
      addFactory();
    }
  }

  byte[] bytes() {
    writer.visitEnd();
    return writer.toByteArray();
  }

  /** Writes the code that makes a lambda of what is on the stack, or takes the one that exists. */
  void writeInstance(MethodVisitor code) {
    if (captured.length == 0) {
      code.visitFieldInsn(
          Opcodes.GETSTATIC, name, INSTANCE, site.getReturnType().getDescriptor());
    } else {
      code.visitMethodInsn(Opcodes.INVOKESTATIC, name, "of", site.getDescriptor(), false);
    }
  }

  private String constructor() {
    return Type.getMethodDescriptor(Type.VOID_TYPE, captured);
  }

  private void addConstructor() {
    MethodVisitor code =
        writer.visitMethod(Opcodes.ACC_PRIVATE, "<init>", constructor(), null, null);
    code.visitCode();
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, "<init>", "()V", false);
    for (int i = 0, local = 1; i < captured.length; local += captured[i++].getSize()) {
      int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_FINAL;
      String type = captured[i].getDescriptor();
      writer.visitField(access, "captured" + i, type, null, null).visitEnd();
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitVarInsn(captured[i].getOpcode(Opcodes.ILOAD), local);
      code.visitFieldInsn(Opcodes.PUTFIELD, name, "captured" + i, type);
    }
    end(code, Type.VOID_TYPE);
  }

  private void addInstance() {
    String type = site.getReturnType().getDescriptor();
    int access = Opcodes.ACC_STATIC | Opcodes.ACC_FINAL;
    writer.visitField(access, INSTANCE, type, null, null).visitEnd();
    MethodVisitor code = writer.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
    code.visitCode();
    writeNew(code);
    code.visitFieldInsn(Opcodes.PUTSTATIC, name, INSTANCE, type);
    end(code, Type.VOID_TYPE);
  }

  private void addFactory() {
    MethodVisitor code =
        writer.visitMethod(Opcodes.ACC_STATIC, "of", site.getDescriptor(), null, null);
    code.visitCode();
    writeNew(code);
    end(code, site.getReturnType());
  }

  /** Writes the code that makes a lambda of the first local variables. */
  private void writeNew(MethodVisitor code) {
    code.visitTypeInsn(Opcodes.NEW, name);
    code.visitInsn(Opcodes.DUP);
    int local = 0;
    for (Type type : captured) {
      code.visitVarInsn(type.getOpcode(Opcodes.ILOAD), local);
      local += type.getSize();
    }
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, name, "<init>", constructor(), false);
  }

  /**
   * Adds the method of the interface.
   *
   * @param erased its types in the interface
   * @param body the method that it calls: first with what is captured, then with its arguments
   * @param called its types where the lambda is made
   */
  void addMethod(String method, Type erased, Handle body, Type called) {
    MethodVisitor code =
        writer.visitMethod(Opcodes.ACC_PUBLIC, method, erased.getDescriptor(), null, null);
    code.visitCode();
    boolean isNew = body.getTag() == Opcodes.H_NEWINVOKESPECIAL;
    if (isNew) {
      code.visitTypeInsn(Opcodes.NEW, body.getOwner());
      code.visitInsn(Opcodes.DUP);
    }
    for (int i = 0; i < captured.length; i++) {
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitFieldInsn(Opcodes.GETFIELD, name, "captured" + i, captured[i].getDescriptor());
    }
    List<Type> parameters = parameters(body);
    Type[] given = erased.getArgumentTypes();
    for (int i = 0, local = 1; i < given.length; local += given[i++].getSize()) {
      code.visitVarInsn(given[i].getOpcode(Opcodes.ILOAD), local);
      Type parameter = parameters.get(captured.length + i);
      convert(code, given[i], called.getArgumentTypes()[i], parameter);
    }
    code.visitMethodInsn(
        call(body), body.getOwner(), body.getName(), body.getDesc(), body.isInterface());
    Type result =
        isNew ? Type.getObjectType(body.getOwner()) : Type.getReturnType(body.getDesc());
    Type expected = erased.getReturnType();
    if (expected != Type.VOID_TYPE) {
      convert(code, result, called.getReturnType(), expected);
    } else if (result != Type.VOID_TYPE) {
      code.visitInsn(result.getSize() == 1 ? Opcodes.POP : Opcodes.POP2);
    }
    end(code, expected);
  }

  private static List<Type> parameters(Handle body) {
    List<Type> parameters = new ArrayList<>();
    if (body.getTag() != Opcodes.H_NEWINVOKESPECIAL && body.getTag() != Opcodes.H_INVOKESTATIC) {
      parameters.add(Type.getObjectType(body.getOwner()));
    }
    parameters.addAll(List.of(Type.getArgumentTypes(body.getDesc())));
    return parameters;
  }

  /** Returns the instruction that calls a method. Those of a nest's private methods are virtual. */
  private static int call(Handle body) {
    return switch (body.getTag()) {
      case Opcodes.H_INVOKESTATIC -> Opcodes.INVOKESTATIC;
      case Opcodes.H_NEWINVOKESPECIAL -> Opcodes.INVOKESPECIAL;
      default -> body.isInterface() ? Opcodes.INVOKEINTERFACE : Opcodes.INVOKEVIRTUAL;
    };
  }

  private static void end(MethodVisitor code, Type result) {
    code.visitInsn(result.getOpcode(Opcodes.IRETURN));
    code.visitMaxs(0, 0);
    code.visitEnd();
  }

  /**
   * Converts the value on the stack.
   *
   * @param called its type where the lambda is made, which tells more than the erased one
   */
  private static void convert(MethodVisitor code, Type from, Type called, Type to) {
    if (isPrimitive(from)) {
      if (isPrimitive(to)) {
        widen(code, from, to);
      } else {
        Type wrapper = WRAPPERS.get(from);
        String method = Type.getMethodDescriptor(wrapper, from);
        code.visitMethodInsn(
            Opcodes.INVOKESTATIC, wrapper.getInternalName(), "valueOf", method, false);
      }
      return;
    }
    Type cast = isPrimitive(called) ? from : called;
    cast(code, from, cast);
    if (isPrimitive(to)) {
      unbox(code, cast, to);
    } else {
      cast(code, cast, to);
    }
  }

  private static void unbox(MethodVisitor code, Type from, Type to) {
    Type primitive = to;
    for (Map.Entry<Type, Type> wrapper : WRAPPERS.entrySet()) {
      if (wrapper.getValue().equals(from)) {
        primitive = wrapper.getKey();
      }
    }
    Type wrapper = WRAPPERS.get(primitive);
    cast(code, from, wrapper);
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL,
        wrapper.getInternalName(),
        primitive.getClassName() + "Value",
        Type.getMethodDescriptor(primitive),
        false);
    widen(code, primitive, to);
  }

  private static boolean isPrimitive(Type type) {
    return WRAPPERS.containsKey(type);
  }

  private static void cast(MethodVisitor code, Type from, Type to) {
    if (!from.equals(to) && !to.getInternalName().equals(OBJECT)) {
      code.visitTypeInsn(Opcodes.CHECKCAST, to.getInternalName());
    }
  }

  private static void widen(MethodVisitor code, Type from, Type to) {
    if (from.equals(to)) {
      return;
    }
    String types = from.getDescriptor() + to.getDescriptor();
    int instruction =
        switch (types) {
          case "IJ" -> Opcodes.I2L;
          case "IF" -> Opcodes.I2F;
          case "ID" -> Opcodes.I2D;
          case "JF" -> Opcodes.L2F;
          case "JD" -> Opcodes.L2D;
          case "FD" -> Opcodes.F2D;
          default ->
              throw new IllegalArgumentException(
                  "expected no conversion of " + types + " in a lambda; add it here");
        };
    code.visitInsn(instruction);
  }
}
