/**
 * Internal: contact generation, one class for each pair of shapes, and the distance kernel.
 *
 * <p>Each class turns two shapes and their transforms into a {@link org.jbox2d.collision.Manifold}.
 * They compute in the frame of one of the two shapes from the relative transform, so that the
 * result does not lose digits far from the world's origin. Nothing here allocates or keeps state
 * between calls.
 *
 * <p>Users call {@link org.jbox2d.collision.Collision}, {@link org.jbox2d.collision.Distance} and
 * {@link org.jbox2d.collision.TimeOfImpact} instead; this package is not exported.
 */
package org.jbox2d.collision.narrowphase;
