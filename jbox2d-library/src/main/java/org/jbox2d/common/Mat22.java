package org.jbox2d.common;

import java.io.Serializable;

/** A matrix of 2 by 2, kept by columns; naming as in {@link Vec2}. */
public class Mat22 implements Serializable {

  private static final long serialVersionUID = 2L;

  /** First column. */
  public final Vec2 ex;

  /** Second column. */
  public final Vec2 ey;

  /** The zero matrix. */
  public Mat22() {
    ex = new Vec2();
    ey = new Vec2();
  }

  /** Copies both columns. */
  public Mat22(Vec2 c1, Vec2 c2) {
    ex = c1.clone();
    ey = c2.clone();
  }

  /** By rows: {@code exx, eyx} is the first row, {@code exy, eyy} the second. */
  public Mat22(float exx, float eyx, float exy, float eyy) {
    ex = new Vec2(exx, exy);
    ey = new Vec2(eyx, eyy);
  }

  public final Mat22 set(Mat22 m) {
    ex.set(m.ex);
    ey.set(m.ey);
    return this;
  }

  /** By rows: {@code exx, eyx} is the first row, {@code exy, eyy} the second. */
  public final Mat22 set(float exx, float eyx, float exy, float eyy) {
    ex.set(exx, exy);
    ey.set(eyx, eyy);
    return this;
  }

  /** By columns. */
  public final void set(Vec2 c1, Vec2 c2) {
    ex.set(c1);
    ey.set(c2);
  }

  /** Sets the counter-clockwise rotation by {@code angle} radians. */
  public final void set(float angle) {
    float s = MathUtils.sin(angle);
    float c = MathUtils.cos(angle);
    set(c, -s, s, c);
  }

  public final void setIdentity() {
    set(1f, 0f, 0f, 1f);
  }

  public final void setZero() {
    set(0f, 0f, 0f, 0f);
  }

  /** The angle of a rotation matrix, in [-pi, pi]. */
  public final float getAngle() {
    return MathUtils.atan2(ex.y, ex.x);
  }

  @Override
  public final Mat22 clone() {
    return new Mat22(ex, ey);
  }

  // Inverse and linear systems, by Cramer's rule. A singular matrix has the zero matrix as its
  // inverse.

  public final Mat22 invert() {
    Mat22 out = new Mat22();
    invertToOut(out);
    return out;
  }

  public final Mat22 invertLocal() {
    invertToOut(this);
    return this;
  }

  public final void invertToOut(Mat22 out) {
    float inverse = inverseDeterminant();
    out.set(inverse * ey.y, -inverse * ey.x, -inverse * ex.y, inverse * ex.x);
  }

  /** The x with {@code this x = b}; zero if this matrix is singular. */
  public final Vec2 solve(Vec2 b) {
    Vec2 out = new Vec2();
    solveToOut(b, out);
    return out;
  }

  /** As {@link #solve}; {@code out} may be {@code b}. */
  public final void solveToOut(Vec2 b, Vec2 out) {
    float inverse = inverseDeterminant();
    float solutionY = inverse * (ex.x * b.y - ex.y * b.x);
    out.x = inverse * (ey.y * b.x - ey.x * b.y);
    out.y = solutionY;
  }

  private float inverseDeterminant() {
    float determinant = ex.x * ey.y - ey.x * ex.y;
    return determinant == 0f ? 0f : 1.0f / determinant;
  }

  // Magnitudes

  public final Mat22 abs() {
    return new Mat22(ex.abs(), ey.abs());
  }

  public final void absLocal() {
    ex.absLocal();
    ey.absLocal();
  }

  public static final Mat22 abs(Mat22 m) {
    return m.abs();
  }

  public static void absToOut(Mat22 m, Mat22 out) {
    Vec2.absToOut(m.ex, out.ex);
    Vec2.absToOut(m.ey, out.ey);
  }

  // Sums

  public final Mat22 add(Mat22 b) {
    return clone().addLocal(b);
  }

  public final Mat22 addLocal(Mat22 b) {
    ex.addLocal(b.ex);
    ey.addLocal(b.ey);
    return this;
  }

  // Products with a vector

  public final Vec2 mul(Vec2 v) {
    return mul(this, v);
  }

  public final void mulToOut(Vec2 v, Vec2 out) {
    mulToOut(this, v, out);
  }

  public final void mulToOutUnsafe(Vec2 v, Vec2 out) {
    mulToOutUnsafe(this, v, out);
  }

  public static final Vec2 mul(Mat22 m, Vec2 v) {
    return new Vec2(m.ex.x * v.x + m.ey.x * v.y, m.ex.y * v.x + m.ey.y * v.y);
  }

  public static final void mulToOut(Mat22 m, Vec2 v, Vec2 out) {
    float productY = m.ex.y * v.x + m.ey.y * v.y;
    out.x = m.ex.x * v.x + m.ey.x * v.y;
    out.y = productY;
  }

  public static final void mulToOutUnsafe(Mat22 m, Vec2 v, Vec2 out) {
    assert out != v;
    out.x = m.ex.x * v.x + m.ey.x * v.y;
    out.y = m.ex.y * v.x + m.ey.y * v.y;
  }

  /** The transpose of this matrix times {@code v}. */
  public final Vec2 mulTrans(Vec2 v) {
    return mulTrans(this, v);
  }

  public final void mulTransToOut(Vec2 v, Vec2 out) {
    mulTransToOut(this, v, out);
  }

  public static final Vec2 mulTrans(Mat22 m, Vec2 v) {
    return new Vec2(Vec2.dot(m.ex, v), Vec2.dot(m.ey, v));
  }

  public static final void mulTransToOut(Mat22 m, Vec2 v, Vec2 out) {
    float productX = Vec2.dot(m.ex, v);
    out.y = Vec2.dot(m.ey, v);
    out.x = productX;
  }

  public static final void mulTransToOutUnsafe(Mat22 m, Vec2 v, Vec2 out) {
    assert out != v;
    out.x = Vec2.dot(m.ex, v);
    out.y = Vec2.dot(m.ey, v);
  }

  // Products with a matrix

  public final Mat22 mul(Mat22 b) {
    return mul(this, b);
  }

  /** {@code this = this b}. */
  public final Mat22 mulLocal(Mat22 b) {
    mulToOut(this, b, this);
    return this;
  }

  public final void mulToOut(Mat22 b, Mat22 out) {
    mulToOut(this, b, out);
  }

  public final void mulToOutUnsafe(Mat22 b, Mat22 out) {
    mulToOutUnsafe(this, b, out);
  }

  public static final Mat22 mul(Mat22 a, Mat22 b) {
    Mat22 out = new Mat22();
    mulToOut(a, b, out);
    return out;
  }

  public static final void mulToOut(Mat22 a, Mat22 b, Mat22 out) {
    float m11 = a.ex.x * b.ex.x + a.ey.x * b.ex.y;
    float m21 = a.ex.y * b.ex.x + a.ey.y * b.ex.y;
    float m12 = a.ex.x * b.ey.x + a.ey.x * b.ey.y;
    float m22 = a.ex.y * b.ey.x + a.ey.y * b.ey.y;
    out.set(m11, m12, m21, m22);
  }

  public static final void mulToOutUnsafe(Mat22 a, Mat22 b, Mat22 out) {
    assert out != a && out != b;
    mulToOut(a, b, out);
  }

  /** The transpose of this matrix times {@code b}. */
  public final Mat22 mulTrans(Mat22 b) {
    return mulTrans(this, b);
  }

  /** {@code this} becomes its transpose times {@code b}. */
  public final Mat22 mulTransLocal(Mat22 b) {
    mulTransToOut(this, b, this);
    return this;
  }

  public final void mulTransToOut(Mat22 b, Mat22 out) {
    mulTransToOut(this, b, out);
  }

  public final void mulTransToOutUnsafe(Mat22 b, Mat22 out) {
    mulTransToOutUnsafe(this, b, out);
  }

  public static final Mat22 mulTrans(Mat22 a, Mat22 b) {
    Mat22 out = new Mat22();
    mulTransToOut(a, b, out);
    return out;
  }

  public static final void mulTransToOut(Mat22 a, Mat22 b, Mat22 out) {
    float m11 = Vec2.dot(a.ex, b.ex);
    float m21 = Vec2.dot(a.ey, b.ex);
    float m12 = Vec2.dot(a.ex, b.ey);
    float m22 = Vec2.dot(a.ey, b.ey);
    out.set(m11, m12, m21, m22);
  }

  public static final void mulTransToOutUnsafe(Mat22 a, Mat22 b, Mat22 out) {
    assert out != a && out != b;
    mulTransToOut(a, b, out);
  }

  // Special matrices

  public static final Mat22 createRotationalTransform(float angle) {
    Mat22 out = new Mat22();
    out.set(angle);
    return out;
  }

  public static final void createRotationalTransform(float angle, Mat22 out) {
    out.set(angle);
  }

  public static final Mat22 createScaleTransform(float scale) {
    return new Mat22(scale, 0f, 0f, scale);
  }

  public static final void createScaleTransform(float scale, Mat22 out) {
    out.set(scale, 0f, 0f, scale);
  }

  @Override
  public String toString() {
    return "[" + ex.x + "," + ey.x + "]\n[" + ex.y + "," + ey.y + "]";
  }

  @Override
  public int hashCode() {
    return 31 * ex.hashCode() + ey.hashCode();
  }

  /** Whether {@code obj} is a matrix with the same bits. */
  @Override
  public boolean equals(Object obj) {
    if (this == obj) {
      return true;
    }
    if (obj == null || obj.getClass() != getClass()) {
      return false;
    }
    Mat22 other = (Mat22) obj;
    return ex.equals(other.ex) && ey.equals(other.ey);
  }
}
