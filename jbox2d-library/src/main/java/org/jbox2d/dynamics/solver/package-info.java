/**
 * Internal: flat arrays of bodies, contact constraints and joint constraints, and the kernels that
 * solve them.
 *
 * <p>Nothing here knows a {@code Body}, {@code Contact} or {@code Joint}: the step pipeline gathers
 * these into the arrays, runs the stages (integrate, prepare, warm start, solve velocities,
 * integrate positions, correct positions) and scatters the results. Units are metres, kilograms,
 * seconds and radians.
 */
package org.jbox2d.dynamics.solver;
