/**
 * Bodies that break on impact: what a program uses.
 *
 * <p>Give a fixture a {@link org.jbox2d.fracture.Material} and it breaks when hit hard enough;
 * there is nothing else to install. {@link org.jbox2d.fracture.FractureSystem#of
 * FractureSystem.of(world)} holds listener, seed and limits. To read how a fracture works, start at
 * {@code FractureSystem.breakRequested} and follow it downwards.
 */
package org.jbox2d.fracture;
