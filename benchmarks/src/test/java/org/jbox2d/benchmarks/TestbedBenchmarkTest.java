package org.jbox2d.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.annotations.Param;

class TestbedBenchmarkTest {
  @Test
  void everySceneOfTheTestbedIsAParameter() throws NoSuchFieldException {
    Param param = TestbedBenchmark.class.getField("scene").getAnnotation(Param.class);
    assertEquals(Scenes.all().stream().map(Scene::name).toList(), List.of(param.value()));
  }

  @Test
  void eachInvocationBeginsAnew() {
    TestbedBenchmark benchmark = new TestbedBenchmark();
    benchmark.scene = "main";
    benchmark.build();
    long first = benchmark.run();
    assertNotEquals(first, benchmark.run());
    benchmark.build();
    assertEquals(first, benchmark.run());
  }
}
