package io.github.lumbre.model.threemf;

import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The entities of XML 1.0 that need no declaration. Stateless. */
final class XmlEntities {
  private static final Pattern ENTITY =
      Pattern.compile("&(?:(amp|lt|gt|quot|apos)|#(\\d{1,7})|#x(\\p{XDigit}{1,6}));");

  private static final Map<String, String> NAMED =
      Map.of("amp", "&", "lt", "<", "gt", ">", "quot", "\"", "apos", "'");

  private XmlEntities() {}

  /** Returns a text with its entities replaced; what is no known entity stays. */
  static String replaced(String text) {
    return text.indexOf('&') < 0
        ? text
        : ENTITY.matcher(text).replaceAll(entity -> Matcher.quoteReplacement(meaning(entity)));
  }

  private static String meaning(MatchResult entity) {
    if (entity.group(1) != null) {
      return NAMED.get(entity.group(1));
    }
    int code =
        entity.group(2) != null
            ? Integer.parseInt(entity.group(2))
            : Integer.parseInt(entity.group(3), 16);
    return Character.isValidCodePoint(code) ? Character.toString(code) : entity.group();
  }
}
