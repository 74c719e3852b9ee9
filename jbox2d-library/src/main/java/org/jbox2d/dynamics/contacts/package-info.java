/**
 * Contacts: when two fixtures begin and cease to touch, where, and what is kept of that from step
 * to step. No solving.
 */
package org.jbox2d.dynamics.contacts;
