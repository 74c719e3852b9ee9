package org.jbox2d.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Links within the repository lead somewhere, and each document is reached from the README. */
class LinkTest {
  @Test
  void targetsExist() {
    List<String> broken = new ArrayList<>();
    int followed = 0;
    for (Document document : Document.all()) {
      for (String link : document.links) {
        if (!link.contains("://") && !link.startsWith("mailto:")) {
          followed++;
          if (!leadsSomewhere(document, link)) {
            broken.add(document + ": " + link);
          }
        }
      }
    }
    assertEquals(List.of(), broken);
    assertTrue(followed > 20, followed + " links");
  }

  private static boolean leadsSomewhere(Document from, String link) {
    int hash = link.indexOf('#');
    String file = hash < 0 ? link : link.substring(0, hash);
    Path target = file.isEmpty() ? from.path : from.path.getParent().resolve(file).normalize();
    if (!target.startsWith(Document.REPOSITORY) || !Files.exists(target)) {
      return false;
    }
    return hash < 0 || Document.of(target).anchors.contains(link.substring(hash + 1));
  }

  @Test
  void documentsAreReachedFromTheReadme() {
    List<Path> reached = new ArrayList<>();
    reached.add(Document.REPOSITORY.resolve("README.md"));
    for (int i = 0; i < reached.size(); i++) {
      Document document = Document.of(reached.get(i));
      for (String link : document.links) {
        Path target = document.path.getParent().resolve(link.replaceAll("#.*", "")).normalize();
        if (target.toString().endsWith(".md")
            && Files.exists(target)
            && !reached.contains(target)) {
          reached.add(target);
        }
      }
    }
    for (Document document : Document.all()) {
      assertTrue(reached.contains(document.path), document + " is linked from nowhere");
    }
  }
}
