package org.jbox2d.common;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class MathUtilsTest {

  /** Half an ulp is the least that rounding to float costs. */
  private static final double MOST_ULPS = 0.51;

  private static final int SAMPLES = 200_000;

  /** Hash of the bits of all results; changes only with the formulas. */
  private static final int GOLDEN = -27778668;

  private static final float[] SPECIAL = {
    0f,
    -0f,
    1f,
    -1f,
    Float.MIN_VALUE,
    -Float.MIN_VALUE,
    Float.MAX_VALUE,
    -Float.MAX_VALUE,
    Float.POSITIVE_INFINITY,
    Float.NEGATIVE_INFINITY,
    Float.NaN
  };

  @AfterEach
  void restoreSettings() {
    Settings.SINCOS_LUT_ENABLED = false;
    Settings.SINCOS_LUT_LERP = true;
    Settings.FAST_ATAN2 = false;
  }

  @Test
  void sineAndCosineAreWithinAnUlpOverAllMagnitudes() {
    Random random = new Random(1);
    for (int i = 0; i < SAMPLES; i++) {
      float x = anyMagnitude(random, -6, 5);
      assertUlps(StrictMath.sin(x), MathUtils.sin(x), x);
      assertUlps(StrictMath.cos(x), MathUtils.cos(x), x);
    }
  }

  @Test
  void sineAndCosineAreWithinAnUlpNearMultiplesOfAQuarterTurn() {
    for (int k = -60_000; k <= 60_000; k += 7) {
      float x = (float) (k * (Math.PI / 2));
      for (float near : new float[] {Math.nextDown(x), x, Math.nextUp(x)}) {
        assertUlps(StrictMath.sin(near), MathUtils.sin(near), near);
        assertUlps(StrictMath.cos(near), MathUtils.cos(near), near);
      }
    }
  }

  @Test
  void sineAndCosineHoldBeyondTheReduction() {
    Random random = new Random(2);
    for (int i = 0; i < 20_000; i++) {
      float x = anyMagnitude(random, 5, 38);
      assertUlps(StrictMath.sin(x), MathUtils.sin(x), x);
      assertUlps(StrictMath.cos(x), MathUtils.cos(x), x);
    }
    assertTrue(Float.isNaN(MathUtils.sin(Float.POSITIVE_INFINITY)));
    assertTrue(Float.isNaN(MathUtils.cos(Float.NaN)));
  }

  @Test
  void arcTangentIsWithinAnUlp() {
    Random random = new Random(3);
    for (int i = 0; i < SAMPLES; i++) {
      float y = anyMagnitude(random, -10, 10);
      float x = anyMagnitude(random, -10, 10);
      assertUlps(StrictMath.atan2(y, x), MathUtils.atan2(y, x), y);
      float sameSize = x * (0.2f + 4f * random.nextFloat());
      assertUlps(StrictMath.atan2(sameSize, x), MathUtils.atan2(sameSize, x), x);
    }
  }

  @Test
  void arcTangentKnowsZerosAndInfinities() {
    for (float y : SPECIAL) {
      for (float x : SPECIAL) {
        int expected = Float.floatToIntBits((float) StrictMath.atan2(y, x));
        assertEquals(expected, Float.floatToIntBits(MathUtils.atan2(y, x)), y + ", " + x);
      }
    }
  }

  /**
   * Known to the last bit: 0.84147098480789650665, 0.54030230586813971740 and so on, rounded to
   * float.
   */
  @Test
  void someValuesAreKnownToTheBit() {
    assertEquals(0x3f576aa4, Float.floatToRawIntBits(MathUtils.sin(1f)));
    assertEquals(0x3f0a5140, Float.floatToRawIntBits(MathUtils.cos(1f)));
    assertEquals(0xb3bbbd2e, Float.floatToRawIntBits(MathUtils.sin(MathUtils.PI)));
    assertEquals(0xb33bbd2e, Float.floatToRawIntBits(MathUtils.cos(MathUtils.HALF_PI)));
    assertEquals(0x80000000, Float.floatToRawIntBits(MathUtils.sin(-0f)));
    assertEquals(0x3f490fdb, Float.floatToRawIntBits(MathUtils.atan2(1f, 1f)));
    assertEquals(0x3eed6338, Float.floatToRawIntBits(MathUtils.atan2(1f, 2f)));
  }

  @Test
  void allBitsAreTheSameOnEveryPlatform() {
    Random random = new Random(4);
    int hash = 1;
    for (int i = 0; i < SAMPLES; i++) {
      float x = anyMagnitude(random, -4, 8);
      float y = anyMagnitude(random, -4, 8);
      hash = 31 * hash + Float.floatToRawIntBits(MathUtils.sin(x));
      hash = 31 * hash + Float.floatToRawIntBits(MathUtils.cos(x));
      hash = 31 * hash + Float.floatToRawIntBits(MathUtils.atan2(y, x));
    }
    assertEquals(GOLDEN, hash);
  }

  @Test
  void tableIsNearTheSineOnceItIsTurnedOn() {
    Random random = new Random(5);
    for (int i = 0; i < 50_000; i++) {
      float x = anyMagnitude(random, -3, 3);
      Settings.SINCOS_LUT_ENABLED = true;
      float sine = MathUtils.sin(x);
      float cosine = MathUtils.cos(x);
      Settings.SINCOS_LUT_LERP = false;
      float nearest = MathUtils.sin(x);
      restoreSettings();
      double argumentRounding = Math.ulp(x) + 1e-6;
      assertEquals(StrictMath.sin(x), sine, argumentRounding);
      assertEquals(StrictMath.cos(x), cosine, argumentRounding);
      assertEquals(StrictMath.sin(x), nearest, argumentRounding + Settings.SINCOS_LUT_PRECISION);
    }
    assertTrue(Float.isNaN(MathUtils.sinLUT(Float.NaN)));
    assertTrue(Float.isNaN(MathUtils.sinLUT(Float.NEGATIVE_INFINITY)));
  }

  @Test
  void fastArcTangentIsWithinItsBound() {
    Settings.FAST_ATAN2 = true;
    for (int i = -1000; i <= 1000; i++) {
      double angle = Math.PI * i / 1000.5;
      float y = (float) (3 * StrictMath.sin(angle));
      float x = (float) (3 * StrictMath.cos(angle));
      assertEquals(angle, MathUtils.atan2(y, x), 0.005);
    }
    assertEquals(0f, MathUtils.atan2(0f, 0f));
  }

  @Test
  void reducedAngleKeepsTheSineAndLiesInAHalfTurn() {
    Random random = new Random(6);
    for (int i = 0; i < 20_000; i++) {
      float x = anyMagnitude(random, -2, 3);
      float reduced = MathUtils.reduceAngle(x);
      assertTrue(Math.abs(reduced) <= MathUtils.HALF_PI);
      assertEquals(StrictMath.sin(x), StrictMath.sin(reduced), 1e-6);
    }
  }

  @Test
  void roundingAgreesWithTheJdk() {
    Random random = new Random(7);
    for (int i = 0; i < 20_000; i++) {
      float x = i % 2 == 0 ? anyMagnitude(random, -2, 8) : random.nextInt(200) - 100;
      assertEquals((int) Math.floor(x), MathUtils.floor(x));
      assertEquals((int) Math.floor(x), MathUtils.fastFloor(x));
      assertEquals((int) Math.ceil(x), MathUtils.ceil(x));
      assertEquals((int) Math.ceil(x), MathUtils.fastCeil(x));
      assertEquals(Math.round(x), MathUtils.round(x));
    }
  }

  @Test
  void powersOfTwo() {
    assertEquals(1, MathUtils.ceilPowerOf2(0));
    assertEquals(8, MathUtils.ceilPowerOf2(8));
    assertEquals(16, MathUtils.ceilPowerOf2(9));
    assertEquals(16, MathUtils.nextPowerOfTwo(8));
    assertEquals(16, MathUtils.nextPowerOfTwo(15));
    assertEquals(1, MathUtils.nextPowerOfTwo(0));
    assertTrue(MathUtils.isPowerOfTwo(64));
    assertFalse(MathUtils.isPowerOfTwo(65));
    assertFalse(MathUtils.isPowerOfTwo(0));
    assertFalse(MathUtils.isPowerOfTwo(Integer.MIN_VALUE));
  }

  @Test
  void rangesAndPowers() {
    assertEquals(2f, MathUtils.clamp(5f, -1f, 2f));
    assertEquals(-1f, MathUtils.clamp(-5f, -1f, 2f));
    assertEquals(0.5f, MathUtils.clamp(0.5f, -1f, 2f));
    Vec2 v = new Vec2(5, -5);
    MathUtils.clampToOut(v, new Vec2(-1, -2), new Vec2(1, 2), v);
    assertEquals(new Vec2(1, -2), v);
    assertEquals(25f, MathUtils.map(0.5f, 0f, 1f, 20f, 30f));
    assertEquals(8f, MathUtils.pow(2f, 3f));
    assertEquals(8f, MathUtils.fastPow(2f, 3f));
    assertEquals(5f, MathUtils.distance(new Vec2(1, 1), new Vec2(4, 5)));
    Random random = new Random(8);
    for (int i = 0; i < 1000; i++) {
      float seeded = MathUtils.randomFloat(random, -3f, 5f);
      float unseeded = MathUtils.randomFloat(-3f, 5f);
      assertTrue(seeded >= -3f && seeded <= 5f && unseeded >= -3f && unseeded <= 5f);
    }
  }

  private static float anyMagnitude(Random random, double lowest, double highest) {
    double size = StrictMath.pow(10, lowest + (highest - lowest) * random.nextDouble());
    return (float) (random.nextBoolean() ? size : -size);
  }

  private static void assertUlps(double expected, float actual, float argument) {
    double ulps = Math.abs(actual - expected) / Math.ulp((float) expected);
    assertTrue(ulps <= MOST_ULPS, () -> "off by " + ulps + " ulp at " + argument);
  }
}
