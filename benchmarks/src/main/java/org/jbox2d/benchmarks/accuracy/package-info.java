/**
 * Scenes whose outcome is known, run in this project's solvers and in other engines, at many
 * settings: how wrong each is, and what it costs. {@link org.jbox2d.benchmarks.accuracy.Accuracy}
 * is the command.
 */
package org.jbox2d.benchmarks.accuracy;
