/** One interface over several engines. A scene is written once, against it. */
package org.jbox2d.benchmarks.engines;
