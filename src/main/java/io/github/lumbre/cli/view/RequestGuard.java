package io.github.lumbre.cli.view;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;
import java.util.Set;

/**
 * Decides which requests the local page's server answers: those for this machine's own names, with
 * the token in the path, and from the page itself. Other users of the machine do not know the
 * token, and pages of other sites have another origin, also if their name resolves to this machine
 * (DNS rebinding). Immutable.
 *
 * @param token the secret first part of every path
 */
record RequestGuard(String token) {
  /** The names of this machine; each may be followed by a port. */
  private static final Set<String> HOSTS = Set.of("127.0.0.1", "localhost", "[::1]");

  private static final Set<String> OWN_SITES = Set.of("same-origin", "none");
  private static final Set<String> READING = Set.of("GET", "HEAD");
  private static final int TOKEN_BYTES = 16;

  /** A refusal: an HTTP status and a text for people. */
  record Refusal(int status, String text) {}

  /**
   * The parts of a request that decide.
   *
   * @param host the header Host; empty if it is missing, as all others
   * @param site the header Sec-Fetch-Site
   */
  record Request(
      String method,
      String path,
      Optional<String> host,
      Optional<String> origin,
      Optional<String> site) {}

  /** Returns a guard with a new token of 128 random bits. */
  static RequestGuard random() {
    byte[] bytes = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(bytes);
    return new RequestGuard(HexFormat.of().formatHex(bytes));
  }

  /** Returns why a request is refused; empty if it is accepted. */
  Optional<Refusal> refusal(Request request) {
    String host = request.host().orElse("");
    if (!HOSTS.contains(host.replaceFirst(":\\d{1,5}$", ""))) {
      return refused(403, "expected the host 127.0.0.1 or localhost");
    }
    if (!startsWithToken(request.path())) {
      return refused(404, "not found: the address is not the one that 'lumbre view' printed");
    }
    boolean isOwn = request.origin().map(("http://" + host)::equals).orElse(true);
    if (!isOwn || !request.site().map(OWN_SITES::contains).orElse(true)) {
      return refused(403, "expected a request of the page itself");
    }
    boolean isPost = request.method().equals("POST");
    if (!isPost && !READING.contains(request.method())) {
      return refused(405, "expected GET, HEAD or POST");
    }
    if (isPost && request.origin().isEmpty()) {
      return refused(403, "expected an Origin");
    }
    return Optional.empty();
  }

  /** Returns the path without the token. */
  String rest(String path) {
    return path.substring(1 + token.length());
  }

  /** Compares in constant time, so that the time does not tell how much of the token is right. */
  private boolean startsWithToken(String path) {
    byte[] expected = ("/" + token + "/").getBytes(StandardCharsets.US_ASCII);
    byte[] found = path.getBytes(StandardCharsets.UTF_8);
    byte[] start = Arrays.copyOf(found, expected.length);
    return MessageDigest.isEqual(expected, start);
  }

  private static Optional<Refusal> refused(int status, String text) {
    return Optional.of(new Refusal(status, text));
  }
}
