/**
 * Vectors, matrices, rigid motions, deterministic mathematics and the tuning constants. Uses the
 * JDK alone.
 */
package org.jbox2d.common;
