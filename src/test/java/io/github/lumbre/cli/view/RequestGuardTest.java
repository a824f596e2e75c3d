package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.view.RequestGuard.Request;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The page answers itself, and nobody else. */
class RequestGuardTest {
  private static final RequestGuard GUARD = new RequestGuard("secret");

  private static int status(String method, String path, String host, String origin, String site) {
    Request request =
        new Request(
            method,
            path,
            Optional.ofNullable(host),
            Optional.ofNullable(origin),
            Optional.ofNullable(site));
    return GUARD.refusal(request).map(RequestGuard.Refusal::status).orElse(200);
  }

  @ParameterizedTest
  @CsvSource({
    "GET,  /secret/,      127.0.0.1:80,     ,                       ,            200",
    "GET,  /secret/,      localhost:9000,   ,                       none,        200",
    "GET,  /secret/state, [::1]:80,         http://[::1]:80,        same-origin, 200",
    "HEAD, /secret/,      127.0.0.1:80,     ,                       ,            200",
    "POST, /secret/do,    127.0.0.1:80,     http://127.0.0.1:80,    same-origin, 200",
    "GET,  /secret,       127.0.0.1:80,     ,                       ,            404",
    "GET,  /,             127.0.0.1:80,     ,                       ,            404",
    "GET,  /Secret/,      127.0.0.1:80,     ,                       ,            404",
    "GET,  /secre/t,      127.0.0.1:80,     ,                       ,            404",
    "GET,  /secretx/,     127.0.0.1:80,     ,                       ,            404",
    "GET,  /secret/,      ,                 ,                       ,            403",
    "GET,  /secret/,      example.com,      ,                       ,            403",
    "GET,  /secret/,      localhost.example.com:80, ,               ,            403",
    "GET,  /secret/,      127.0.0.1:80:80,  ,                       ,            403",
    "GET,  /secret/,      127.0.0.1.example.com, ,                  ,            403",
    "GET,  /secret/state, 127.0.0.1:80,     http://example.com,     ,            403",
    "GET,  /secret/state, 127.0.0.1:80,     http://127.0.0.1:81,    ,            403",
    "GET,  /secret/state, 127.0.0.1:80,     https://127.0.0.1:80,   ,            403",
    "GET,  /secret/state, 127.0.0.1:80,     null,                   ,            403",
    "GET,  /secret/state, 127.0.0.1:80,     ,                       cross-site,  403",
    "GET,  /secret/state, 127.0.0.1:80,     ,                       same-site,   403",
    "HEAD, /secret/,      example.com,      ,                       ,            403",
    "POST, /secret/do,    127.0.0.1:80,     ,                       ,            403",
    "POST, /secret/do,    127.0.0.1:80,     http://example.com,     ,            403",
    "PUT,  /secret/do,    127.0.0.1:80,     http://127.0.0.1:80,    ,            405",
    "OPTIONS, /secret/do, 127.0.0.1:80,     ,                       ,            405"
  })
  void refusesOthers(
      String method, String path, String host, String origin, String site, int expected) {
    assertThat(status(method, path, host, origin, site)).isEqualTo(expected);
  }

  @Test
  void tokensAreLongAndDiffer() {
    String token = RequestGuard.random().token();
    assertThat(token).matches("[0-9a-f]{32}").isNotEqualTo(RequestGuard.random().token());
  }
}
