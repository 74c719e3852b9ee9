/**
 * Scenes whose steps are timed, in any engine. Those with a name of the Box2D 3 benchmark program
 * have its layout and numbers of bodies.
 */
package org.jbox2d.benchmarks.scenes;
