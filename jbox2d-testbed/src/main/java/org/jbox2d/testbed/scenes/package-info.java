/**
 * The scenes, in one registry for window, headless runs, tests and benchmarks. No AWT here: {@link
 * org.jbox2d.testbed.scenes.Scene#build} needs nothing but a world.
 */
package org.jbox2d.testbed.scenes;
