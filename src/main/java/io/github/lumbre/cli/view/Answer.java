package io.github.lumbre.cli.view;

import java.nio.charset.StandardCharsets;
import java.util.Map;

/** An answer of the local page's server. */
record Answer(int status, String type, Map<String, String> headers, byte[] body) {
  static Answer json(String text) {
    return new Answer(200, "application/json; charset=utf-8", Map.of(), utf8(text));
  }

  static Answer bytes(byte[] body) {
    return new Answer(200, "application/octet-stream", Map.of(), body);
  }

  Answer with(String header, String value) {
    return new Answer(status, type, Map.of(header, value), body);
  }

  /** Returns a file that the browser saves. */
  static Answer file(String name, String type, byte[] body) {
    String safe = name.replaceAll("[^A-Za-z0-9._-]", "_");
    return new Answer(
        200, type, Map.of("Content-Disposition", "attachment; filename=\"" + safe + "\""), body);
  }

  /** Returns an answer without content: what is wanted will exist later. */
  static Answer nothingYet() {
    return new Answer(204, "text/plain", Map.of(), new byte[0]);
  }

  static Answer refused(int status, String text) {
    return new Answer(status, "text/plain; charset=utf-8", Map.of(), utf8(text + "\n"));
  }

  /** Returns the page, which may run and load nothing but its own parts. */
  static Answer page(String text, String nonce) {
    String policy =
        "default-src 'none'; script-src 'nonce-%s'; style-src 'nonce-%s'; connect-src 'self';"
            + " img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    return new Answer(
        200,
        "text/html; charset=utf-8",
        Map.of("Content-Security-Policy", policy.formatted(nonce, nonce)),
        utf8(text));
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
