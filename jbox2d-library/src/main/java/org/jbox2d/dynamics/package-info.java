/**
 * Worlds, bodies, fixtures and their definitions: what a program uses; and, package-private, the
 * pipeline of a step.
 *
 * <p>To read how a step works, start at {@link org.jbox2d.dynamics.World#step World.step} and
 * follow it downwards. Units are metres, kilograms, seconds and radians.
 */
package org.jbox2d.dynamics;
