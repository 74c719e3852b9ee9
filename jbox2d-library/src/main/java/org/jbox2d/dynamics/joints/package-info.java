/**
 * Joints: what holds bodies together. A class and a definition each; their kernels are in the
 * solver.
 */
package org.jbox2d.dynamics.joints;
