/** Draws snapshots with Java2D, for the window and for the headless runner's pictures. */
package org.jbox2d.testbed.paint;
