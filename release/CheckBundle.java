import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathFactory;
import org.w3c.dom.Document;

/**
 * Checks a release bundle against what Maven Central demands: {@code java release/CheckBundle.java
 * BUNDLE.zip}. Exits with 1 and prints every problem if something is missing or wrong.
 */
final class CheckBundle {
  private static final List<String> KINDS =
      List.of(
          ".jar",
          "-sources.jar",
          "-javadoc.jar",
          "-cli.jar",
          "-lab.jar",
          "-cyclonedx.json",
          ".pom");
  private static final Map<String, String> DIGESTS =
      new TreeMap<>(
          Map.of("md5", "MD5", "sha1", "SHA-1", "sha256", "SHA-256", "sha512", "SHA-512"));
  private static final List<String> ELEMENTS =
      List.of(
          "groupId",
          "artifactId",
          "version",
          "name",
          "description",
          "url",
          "licenses/license/name",
          "licenses/license/url",
          "developers/developer/name",
          "scm/url",
          "scm/connection");

  private final ZipFile bundle;
  private final List<String> problems = new ArrayList<>();

  private CheckBundle(ZipFile bundle) {
    this.bundle = bundle;
  }

  public static void main(String[] args) throws Exception {
    if (args.length != 1 || !Files.isRegularFile(Path.of(args[0]))) {
      System.err.println("usage: java release/CheckBundle.java BUNDLE.zip");
      System.exit(2);
    }
    try (ZipFile bundle = new ZipFile(args[0])) {
      CheckBundle check = new CheckBundle(bundle);
      check.run();
      check.problems.forEach(System.err::println);
      System.exit(check.problems.isEmpty() ? 0 : 1);
    }
  }

  private void run() throws Exception {
    TreeSet<String> files = new TreeSet<>();
    bundle.stream().filter(e -> !e.isDirectory()).map(ZipEntry::getName).forEach(files::add);
    String pom = files.stream().filter(name -> name.endsWith(".pom")).findFirst().orElse("");
    if (pom.isEmpty()) {
      problems.add("the bundle holds no .pom");
      return;
    }
    String stem = pom.substring(0, pom.length() - ".pom".length());
    checkPom(pom, stem);
    TreeSet<String> expected = new TreeSet<>();
    for (String kind : KINDS) {
      String name = stem + kind;
      expected.add(name);
      expected.add(name + ".asc");
      DIGESTS.keySet().forEach(digest -> expected.add(name + '.' + digest));
      if (files.contains(name)) {
        checkDigests(name);
      }
    }
    expected.stream()
        .filter(name -> !files.contains(name))
        .forEach(name -> problems.add(name + ": is missing"));
    files.stream()
        .filter(name -> !expected.contains(name) && !name.contains(".asc."))
        .forEach(name -> problems.add(name + ": is not expected in a release"));
    checkJars(stem);
    long bytes = bundle.stream().mapToLong(ZipEntry::getSize).sum();
    System.out.printf("%s: %d files, %d bytes%n", stem, files.size(), bytes);
  }

  private void checkPom(String name, String stem) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    Document pom;
    try (InputStream in = bundle.getInputStream(bundle.getEntry(name))) {
      pom = factory.newDocumentBuilder().parse(in);
    }
    XPath path = XPathFactory.newInstance().newXPath();
    for (String element : ELEMENTS) {
      String value = resolve(path.evaluate("/project/" + element, pom), pom, path);
      if (value.isEmpty() || value.contains("${")) {
        problems.add(name + ": <" + element + "> is empty or has no value");
      } else if (value.contains(".invalid") && !Boolean.getBoolean("dry")) {
        problems.add(name + ": <" + element + "> is " + value + "; set it with release/prepare");
      }
    }
    String version = path.evaluate("/project/version", pom);
    if (version.endsWith("-SNAPSHOT") && !Boolean.getBoolean("dry")) {
      problems.add(name + ": " + version + " is no version of a release");
    }
    String folder =
        path.evaluate("/project/groupId", pom).replace('.', '/')
            + "/"
            + path.evaluate("/project/artifactId", pom)
            + "/"
            + version;
    if (!stem.startsWith(folder + "/")) {
      problems.add(name + ": is not in the folder " + folder);
    }
    int count = Integer.parseInt(path.evaluate("count(//repositories|//parent)", pom));
    if (count != 0) {
      problems.add(name + ": names repositories or a parent, which consumers may not reach");
    }
  }

  /** Replaces the properties that the POM itself defines, as consumers do. */
  private static String resolve(String value, Document pom, XPath path) throws Exception {
    String resolved = value.strip();
    for (int start; (start = resolved.indexOf("${")) >= 0; ) {
      int end = resolved.indexOf('}', start);
      String property = resolved.substring(start + 2, end);
      String found = path.evaluate("/project/properties/*[name()='" + property + "']", pom);
      if (found.isEmpty()) {
        return resolved;
      }
      resolved = resolved.substring(0, start) + found + resolved.substring(end + 1);
    }
    return resolved;
  }

  private void checkDigests(String name) throws IOException, NoSuchAlgorithmException {
    byte[] content = read(name);
    for (Map.Entry<String, String> digest : DIGESTS.entrySet()) {
      String file = name + '.' + digest.getKey();
      if (bundle.getEntry(file) != null) {
        String stated = new String(read(file), StandardCharsets.US_ASCII).strip();
        byte[] computed = MessageDigest.getInstance(digest.getValue()).digest(content);
        if (!stated.equals(HexFormat.of().formatHex(computed))) {
          problems.add(file + ": does not match the file's content");
        }
      }
    }
  }

  private void checkJars(String stem) throws IOException {
    checkContent(stem + ".jar", "io/github/lumbre/render/PictureRenderer.class", "lumbre/cli/");
    checkContent(stem + "-cli.jar", "io/github/lumbre/cli/Lumbre.class", "module-info.class");
    checkContent(stem + "-cli.jar", "io/github/lumbre/cli/Lumbre.class", "lumbre/lab/");
    checkContent(stem + "-lab.jar", "io/github/lumbre/lab/Trial.class", "lumbre/cli/");
    checkContent(stem + "-sources.jar", "io/github/lumbre/render/PictureRenderer.java", ".class");
    checkContent(stem + "-javadoc.jar", "index.html", "lumbre/cli/");
    for (String kind : List.of(".jar", "-cli.jar", "-lab.jar")) {
      checkContent(stem + kind, "META-INF/LICENSE", "-INF/native-image/none");
      checkContent(stem + kind, "META-INF/NOTICE", "-INF/native-image/none");
    }
  }

  private void checkContent(String jar, String required, String forbidden) throws IOException {
    if (bundle.getEntry(jar) == null) {
      return;
    }
    Path copy = Files.createTempFile("lumbre-bundle", ".jar");
    try {
      Files.write(copy, read(jar));
      try (ZipFile zip = new ZipFile(copy.toFile())) {
        if (zip.stream().noneMatch(entry -> entry.getName().endsWith(required))) {
          problems.add(jar + ": holds no " + required);
        }
        if (zip.stream().anyMatch(entry -> entry.getName().contains(forbidden))) {
          problems.add(jar + ": holds " + forbidden + ", which belongs elsewhere");
        }
      }
    } finally {
      Files.delete(copy);
    }
  }

  private byte[] read(String name) throws IOException {
    try (InputStream in = bundle.getInputStream(bundle.getEntry(name))) {
      return in.readAllBytes();
    }
  }
}
