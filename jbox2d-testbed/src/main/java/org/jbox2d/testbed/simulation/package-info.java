/** A run of a scene, what can be measured of it, and pictures of its state. No AWT here. */
package org.jbox2d.testbed.simulation;
