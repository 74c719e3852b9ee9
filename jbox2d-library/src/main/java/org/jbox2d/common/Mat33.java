package org.jbox2d.common;

import java.io.Serializable;

/** A matrix of 3 by 3, kept by columns; naming as in {@link Vec2}. */
public class Mat33 implements Serializable {

  private static final long serialVersionUID = 2L;

  /** Read it only. */
  public static final Mat33 IDENTITY =
      new Mat33(new Vec3(1f, 0f, 0f), new Vec3(0f, 1f, 0f), new Vec3(0f, 0f, 1f));

  /** First column. */
  public final Vec3 ex;

  /** Second column. */
  public final Vec3 ey;

  /** Third column. */
  public final Vec3 ez;

  /** The zero matrix. */
  public Mat33() {
    ex = new Vec3();
    ey = new Vec3();
    ez = new Vec3();
  }

  /** By columns: the first three numbers are the first column. */
  public Mat33(
      float exx,
      float exy,
      float exz,
      float eyx,
      float eyy,
      float eyz,
      float ezx,
      float ezy,
      float ezz) {
    ex = new Vec3(exx, exy, exz);
    ey = new Vec3(eyx, eyy, eyz);
    ez = new Vec3(ezx, ezy, ezz);
  }

  /** Copies the columns. */
  public Mat33(Vec3 argCol1, Vec3 argCol2, Vec3 argCol3) {
    ex = argCol1.clone();
    ey = argCol2.clone();
    ez = argCol3.clone();
  }

  public void setZero() {
    ex.setZero();
    ey.setZero();
    ez.setZero();
  }

  /** By columns: the first three numbers are the first column. */
  public void set(
      float exx,
      float exy,
      float exz,
      float eyx,
      float eyy,
      float eyz,
      float ezx,
      float ezy,
      float ezz) {
    ex.set(exx, exy, exz);
    ey.set(eyx, eyy, eyz);
    ez.set(ezx, ezy, ezz);
  }

  public void set(Mat33 mat) {
    ex.set(mat.ex);
    ey.set(mat.ey);
    ez.set(mat.ez);
  }

  public void setIdentity() {
    set(1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f);
  }

  /** Sets {@code out} to the scaling of the plane by {@code scale} in homogeneous coordinates. */
  public static final void setScaleTransform(float scale, Mat33 out) {
    out.set(scale, 0f, 0f, 0f, scale, 0f, 0f, 0f, 1f);
  }

  // Products

  public static final Vec3 mul(Mat33 m, Vec3 v) {
    Vec3 out = new Vec3();
    mulToOutUnsafe(m, v, out);
    return out;
  }

  public static final void mulToOut(Mat33 m, Vec3 v, Vec3 out) {
    float px = m.ex.x * v.x + m.ey.x * v.y + m.ez.x * v.z;
    float py = m.ex.y * v.x + m.ey.y * v.y + m.ez.y * v.z;
    float pz = m.ex.z * v.x + m.ey.z * v.y + m.ez.z * v.z;
    out.set(px, py, pz);
  }

  public static final void mulToOutUnsafe(Mat33 m, Vec3 v, Vec3 out) {
    assert out != v;
    mulToOut(m, v, out);
  }

  /** The upper left 2 by 2 block times {@code v}. */
  public static final Vec2 mul22(Mat33 m, Vec2 v) {
    Vec2 out = new Vec2();
    mul22ToOutUnsafe(m, v, out);
    return out;
  }

  public static final void mul22ToOut(Mat33 m, Vec2 v, Vec2 out) {
    float productY = m.ex.y * v.x + m.ey.y * v.y;
    out.x = m.ex.x * v.x + m.ey.x * v.y;
    out.y = productY;
  }

  public static final void mul22ToOutUnsafe(Mat33 m, Vec2 v, Vec2 out) {
    assert out != v;
    mul22ToOut(m, v, out);
  }

  // Linear systems and inverses, by Cramer's rule; a singular matrix gives zero.

  /** The x with {@code block x = b} for the upper left 2 by 2 block. */
  public final Vec2 solve22(Vec2 b) {
    Vec2 out = new Vec2();
    solve22ToOut(b, out);
    return out;
  }

  /** As {@link #solve22}; {@code out} may be {@code b}. */
  public final void solve22ToOut(Vec2 b, Vec2 out) {
    float inverse = reciprocalOrZero(ex.x * ey.y - ey.x * ex.y);
    float solutionY = inverse * (ex.x * b.y - ex.y * b.x);
    out.x = inverse * (ey.y * b.x - ey.x * b.y);
    out.y = solutionY;
  }

  /** The x with {@code this x = b}. */
  public final Vec3 solve33(Vec3 b) {
    Vec3 out = new Vec3();
    solve33ToOut(b, out);
    return out;
  }

  /**
   * As {@link #solve33}, where {@code out} may be {@code b}. Each coordinate is the ratio of two
   * triple products: x = b . (ey x ez) / det, and so on in turn.
   */
  public final void solve33ToOut(Vec3 b, Vec3 out) {
    float yzX = ey.y * ez.z - ey.z * ez.y;
    float yzY = ey.z * ez.x - ey.x * ez.z;
    float yzZ = ey.x * ez.y - ey.y * ez.x;
    float inverse = reciprocalOrZero(ex.x * yzX + ex.y * yzY + ex.z * yzZ);
    float bzX = b.y * ez.z - b.z * ez.y;
    float bzY = b.z * ez.x - b.x * ez.z;
    float bzZ = b.x * ez.y - b.y * ez.x;
    float ybX = ey.y * b.z - ey.z * b.y;
    float ybY = ey.z * b.x - ey.x * b.z;
    float ybZ = ey.x * b.y - ey.y * b.x;
    float first = inverse * (b.x * yzX + b.y * yzY + b.z * yzZ);
    float second = inverse * (ex.x * bzX + ex.y * bzY + ex.z * bzZ);
    float third = inverse * (ex.x * ybX + ex.y * ybY + ex.z * ybZ);
    out.set(first, second, third);
  }

  /** Writes the inverse of the upper left 2 by 2 block; the rest of {@code m} becomes zero. */
  public void getInverse22(Mat33 m) {
    float a = ex.x;
    float b = ey.x;
    float c = ex.y;
    float d = ey.y;
    float inverse = reciprocalOrZero(a * d - b * c);
    m.set(inverse * d, -inverse * c, 0f, -inverse * b, inverse * a, 0f, 0f, 0f, 0f);
  }

  /**
   * Writes the inverse of this matrix, of which only the diagonal and what is above it are read: it
   * must be symmetric.
   */
  public void getSymInverse33(Mat33 m) {
    float a11 = ex.x;
    float a12 = ey.x;
    float a13 = ez.x;
    float a22 = ey.y;
    float a23 = ez.y;
    float a33 = ez.z;
    float c11 = a22 * a33 - a23 * a23;
    float c12 = a13 * a23 - a12 * a33;
    float c13 = a12 * a23 - a13 * a22;
    float inverse = reciprocalOrZero(a11 * c11 + a12 * c12 + a13 * c13);
    float m12 = inverse * c12;
    float m13 = inverse * c13;
    float m23 = inverse * (a12 * a13 - a11 * a23);
    float m22 = inverse * (a11 * a33 - a13 * a13);
    float m33 = inverse * (a11 * a22 - a12 * a12);
    m.set(inverse * c11, m12, m13, m12, m22, m23, m13, m23, m33);
  }

  private static float reciprocalOrZero(float determinant) {
    return determinant == 0f ? 0f : 1.0f / determinant;
  }

  @Override
  public int hashCode() {
    return 31 * (31 * ex.hashCode() + ey.hashCode()) + ez.hashCode();
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
    Mat33 other = (Mat33) obj;
    return ex.equals(other.ex) && ey.equals(other.ey) && ez.equals(other.ez);
  }
}
