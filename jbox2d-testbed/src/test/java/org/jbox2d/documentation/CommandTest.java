package org.jbox2d.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jbox2d.documentation.Document.Block;
import org.junit.jupiter.api.Test;

/** The commands that the documents give are there; those of the README are run by CI as written. */
class CommandTest {
  @Test
  void commandsOfTheReadmeAreRunByCi() throws IOException {
    String ci = Files.readString(Document.REPOSITORY.resolve(".ci/run"));
    Document readme = Document.of(Document.REPOSITORY.resolve("README.md"));
    List<String> missing = new ArrayList<>();
    int commands = 0;
    for (Block block : readme.blocks) {
      if (block.language().equals("sh")) {
        for (String command : block.code().split("(?<!\\\\)\n")) {
          commands++;
          if (!ci.contains(command)) {
            missing.add(command);
          }
        }
      }
    }
    assertEquals(List.of(), missing);
    assertTrue(commands >= 3, commands + " commands");
  }

  /** What {@code java -cp some.jar a.b.Main} starts is a class of ours, with a main method. */
  @Test
  void classesThatAreStartedExist() throws IOException {
    Pattern start = Pattern.compile("java -cp \\S+\\s+(org\\.jbox2d\\.[\\w.]*\\w)");
    int found = 0;
    for (Document document : Document.all()) {
      Matcher matcher = start.matcher(document.text);
      while (matcher.find()) {
        found++;
        String name = matcher.group(1);
        Path source =
            Document.REPOSITORY.resolve(
                "benchmarks/src/main/java/" + name.replace('.', '/') + ".java");
        assertTrue(Files.exists(source), document + ": " + name);
        assertTrue(Files.readString(source).contains("void main(String"), name);
      }
    }
    assertTrue(found > 0);
  }

  /** What a test is to be run with {@code -Dtest=Name} exists in the module that is named. */
  @Test
  void testsThatAreNamedExist() throws IOException {
    Pattern test = Pattern.compile("-pl (\\S+)[^`]*?-Dtest=(\\w+)");
    for (Document document : Document.all()) {
      Matcher matcher = test.matcher(document.text);
      while (matcher.find()) {
        Path sources = Document.REPOSITORY.resolve(matcher.group(1)).resolve("src/test/java");
        String file = matcher.group(2) + ".java";
        try (var files = Files.walk(sources)) {
          assertTrue(files.anyMatch(f -> f.endsWith(file)), document + ": " + file);
        }
      }
    }
  }
}
