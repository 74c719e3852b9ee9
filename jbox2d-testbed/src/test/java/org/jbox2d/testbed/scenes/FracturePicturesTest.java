package org.jbox2d.testbed.scenes;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Bricks;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Radial;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;
import org.jbox2d.testbed.paint.Palette;
import org.jbox2d.testbed.paint.SnapshotPainter;
import org.jbox2d.testbed.paint.View;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.SnapshotTaker;
import org.junit.jupiter.api.Test;

/**
 * Draws the pictures of the guide to fracture: what rigidity, radius and shattering do (thesis,
 * section 7.3), and each material as it breaks and a little later. Given a directory as the system
 * property {@code fracture.pictures}, writes them there: {@code mvn -q -pl jbox2d-testbed -am test
 * -Dtest=FracturePicturesTest -Dsurefire.failIfNoSpecifiedTests=false
 * -Dfracture.pictures=$PWD/docs/pictures/fracture}.
 */
class FracturePicturesTest {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 240;
  private static final float HZ = 60f;

  /** Longest wait for the first fracture, steps. */
  private static final int PATIENCE = 60;

  private static final int STEPS_LATER = 18;

  /** A square of 10 m in free space that is hit by a heavy disc. */
  private static Scene scene(Material material) {
    return Scene.of(
            "study",
            "study",
            "A disc hits a square.",
            world -> {
              Stage stage = new Stage(world);
              stage.scenery(0f, -5f, 40f, 5f);
              stage.box(0f, 5f, 5f, 5f, Stage.breakable(material));
              stage.shot(-12f, 5.3f, 1f, 5f, 60f, 0f);
            })
        .seen(0.5f, 5f, 17f, 12f);
  }

  private static Simulation brokenBy(Material material, int stepsLater) {
    Simulation run = new Simulation(scene(material), HZ, 1);
    FractureSystem system = FractureSystem.of(run.world());
    for (int i = 0; i < PATIENCE && system.getFractureCount() == 0; i++) {
      run.step();
    }
    assertTrue(system.getFractureCount() > 0, material.getClass() + " did not break");
    for (int i = 0; i < stepsLater; i++) {
      run.step();
    }
    return run;
  }

  private static BufferedImage strip(Simulation... runs) {
    BufferedImage strip = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    Graphics g = strip.getGraphics();
    int width = WIDTH / runs.length;
    for (int i = 0; i < runs.length; i++) {
      View view = View.of(scene(new Uniform()).framing(), width - 2, HEIGHT);
      g.drawImage(
          new SnapshotPainter(Palette.DARK).image(new SnapshotTaker(runs[i]).take(), view),
          i * width + 1,
          0,
          null);
    }
    g.dispose();
    return strip;
  }

  private static void show(String name, BufferedImage picture) throws IOException {
    String directory = System.getProperty("fracture.pictures");
    if (directory != null) {
      ImageIO.write(picture, "png", new File(directory, name + ".png"));
    }
  }

  private static Simulation study(float rigidity, float radius, float shattering) {
    return brokenBy(Stage.tuned(new Uniform(), rigidity, shattering, radius), STEPS_LATER);
  }

  @Test
  void parameters() throws IOException {
    Simulation[] rigid = {study(100, 2, 4), study(50, 2, 4), study(20, 2, 4)};
    show("rigidity", strip(rigid));
    Simulation[] wide = {study(40, 1, 4), study(40, 2, 4), study(40, 5, 4)};
    show("radius", strip(wide));
    assertTrue(
        wide[0].world().getBodyCount() < wide[2].world().getBodyCount(),
        "a larger radius breaks more");
    Simulation[] fine = {study(40, 3, 10), study(40, 3, 4), study(40, 3, 1.5f)};
    show("shattering", strip(fine));
    assertTrue(
        fine[0].world().getBodyCount() < fine[2].world().getBodyCount(),
        "less shattering gives finer pieces");
  }

  @Test
  void materials() throws IOException {
    Map<String, Supplier<Material>> all = new LinkedHashMap<>();
    all.put("uniform", Uniform::new);
    all.put("diffusion", Diffusion::new);
    all.put("glass", Glass::new);
    all.put("radial", Radial::new);
    all.put("splinters", FracturePicturesTest::wood);
    all.put("bricks", Bricks::new);
    for (Map.Entry<String, Supplier<Material>> entry : all.entrySet()) {
      Supplier<Material> made = () -> Stage.tuned(entry.getValue().get(), 40f);
      Simulation[] runs = {brokenBy(wide(made.get()), 0), brokenBy(wide(made.get()), STEPS_LATER)};
      show("material-" + entry.getKey(), strip(runs));
    }
  }

  private static Material wide(Material material) {
    material.m_radius = 3.5f;
    return material;
  }

  private static Material wood() {
    Splinters wood = new Splinters();
    wood.setAngle(1.5f);
    wood.m_shattering = 3f;
    return wood;
  }
}
