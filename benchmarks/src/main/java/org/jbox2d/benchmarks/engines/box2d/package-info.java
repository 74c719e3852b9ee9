/** The adapter for JBox2D's API. Its classes are loaded once for each engine that has that API. */
package org.jbox2d.benchmarks.engines.box2d;
