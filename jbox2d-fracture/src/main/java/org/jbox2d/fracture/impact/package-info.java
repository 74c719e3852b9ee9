/**
 * From solved contacts to requests: how hard a blow was, where it struck, and what the broken body
 * did not take of it.
 */
package org.jbox2d.fracture.impact;
