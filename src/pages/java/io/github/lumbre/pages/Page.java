package io.github.lumbre.pages;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.task.list.items.TaskListItemsExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * A page of the site.
 *
 * @param source the Markdown file, relative to the repository
 * @param target the HTML file, relative to the site
 * @param title of the page, plain text
 * @param html its content, with links as in the source
 */
record Page(Path source, Path target, String title, String html) {
  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), TaskListItemsExtension.create());

  /** Renders a Markdown file. */
  static Page of(Path source, String markdown) {
    Node document = Parser.builder().extensions(EXTENSIONS).build().parse(markdown);
    Map<String, Integer> used = new HashMap<>();
    Map<Node, String> anchors = new HashMap<>();
    String[] title = {source.getFileName().toString()};
    document.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Heading heading) {
            String text = text(heading);
            if (heading.getLevel() == 1) {
              title[0] = text;
            }
            String anchor = anchor(text);
            int count = used.merge(anchor, 1, Integer::sum);
            anchors.put(heading, count == 1 ? anchor : anchor + "-" + (count - 1));
          }
        });
    String html =
        HtmlRenderer.builder()
            .extensions(EXTENSIONS)
            .attributeProviderFactory(
                context ->
                    (node, tag, attributes) -> {
                      if (node instanceof Heading) {
                        attributes.put("id", anchors.get(node));
                      }
                    })
            .build()
            .render(document);
    return new Page(source, target(source), title[0], html);
  }

  private static Path target(Path source) {
    String name = source.getFileName().toString();
    String page =
        name.equals("README.md") ? "index.html" : name.replaceAll("\\.md$", ".html");
    Path folder = source.getNameCount() == 1 ? Path.of("project") : source.getParent();
    return folder.resolve(page);
  }

  /** Returns the anchor of a heading, as code hosts generate it. */
  static String anchor(String heading) {
    return heading.strip().toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "").replace(' ', '-');
  }

  private static String text(Node node) {
    StringBuilder text = new StringBuilder();
    node.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Text part) {
            text.append(part.getLiteral());
          }

          @Override
          public void visit(Code part) {
            text.append(part.getLiteral());
          }
        });
    return text.toString();
  }

  /** Returns the name of the source without its ending. */
  String name() {
    return source.getFileName().toString().replaceAll("\\.md$", "");
  }

  /** Returns a title that fits into the navigation. */
  String shortTitle() {
    if (name().equals("README")) {
      return switch (source.getName(0).toString()) {
        case "docs" -> "All pages";
        default -> "Pictures and times";
      };
    }
    return title.replaceAll("[:,(].*", "").strip();
  }

  /** Returns text as HTML. */
  static String escape(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }
}
