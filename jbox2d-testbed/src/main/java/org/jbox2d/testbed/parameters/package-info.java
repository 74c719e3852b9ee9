/**
 * Values that a user may change: one description serves side panel, command line and recordings.
 */
package org.jbox2d.testbed.parameters;
