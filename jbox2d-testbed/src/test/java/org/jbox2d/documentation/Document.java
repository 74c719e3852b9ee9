package org.jbox2d.documentation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A document in Markdown: its blocks of code, its links and the anchors of its headings. */
final class Document {
  /** The repository, seen from the folder of a module, where Maven runs the tests. */
  static final Path REPOSITORY = Path.of("..").toAbsolutePath().normalize();

  private static final Pattern FENCE = Pattern.compile("\\s*```(\\w*)\\s*");

  /** A line that is the name of a file and says that the block below is that file. */
  private static final Pattern FILE = Pattern.compile("`([\\w./-]+)`:");

  /** The target of a link or of a picture; what follows a blank is its title. */
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)[^)]*\\)");

  private static final Pattern HEADING = Pattern.compile("#+ +(.*)");

  final Path path;
  final String text;
  final List<Block> blocks = new ArrayList<>();
  final List<String> links = new ArrayList<>();
  final Set<String> anchors = new HashSet<>();

  /** A block of code; {@code file} is the file that it is said to be, or null. */
  record Block(Document document, int line, String language, String file, String code) {
    @Override
    public String toString() {
      return document + ":" + line;
    }
  }

  private Document(Path path) throws IOException {
    this.path = path;
    text = Files.readString(path);
    read(text.split("\n", -1));
  }

  private void read(String[] lines) {
    String lastText = "";
    for (int i = 0; i < lines.length; i++) {
      Matcher fence = FENCE.matcher(lines[i]);
      if (!fence.matches()) {
        readText(lines[i]);
        lastText = lines[i].isBlank() ? lastText : lines[i];
        continue;
      }
      int first = i + 1;
      StringBuilder code = new StringBuilder();
      for (i = first; !FENCE.matcher(lines[i]).matches(); i++) {
        code.append(lines[i]).append('\n');
      }
      Matcher file = FILE.matcher(lastText.trim());
      String name = file.matches() ? file.group(1) : null;
      blocks.add(new Block(this, first, fence.group(1), name, code.toString()));
      lastText = "";
    }
  }

  private void readText(String line) {
    Matcher heading = HEADING.matcher(line);
    if (heading.matches()) {
      anchors.add(anchorOf(heading.group(1)));
    }
    Matcher link = LINK.matcher(line);
    while (link.find()) {
      links.add(link.group(1));
    }
  }

  /** As the web sites that show Markdown make them. */
  private static String anchorOf(String heading) {
    return heading.toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "").replace(' ', '-');
  }

  static Document of(Path path) {
    try {
      return new Document(path);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The documents at the top of the repository, and all below {@code docs}. */
  static List<Document> all() {
    try (Stream<Path> top = Files.list(REPOSITORY);
        Stream<Path> docs = Files.walk(REPOSITORY.resolve("docs"))) {
      return Stream.concat(top, docs)
          .filter(p -> p.toString().endsWith(".md"))
          .sorted()
          .map(Document::of)
          .collect(Collectors.toList());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The blocks of all documents in a language. */
  static List<Block> blocksIn(String language) {
    return all().stream()
        .flatMap(d -> d.blocks.stream())
        .filter(b -> b.language().equals(language))
        .collect(Collectors.toList());
  }

  @Override
  public String toString() {
    return REPOSITORY.relativize(path).toString();
  }
}
