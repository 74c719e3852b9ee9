/**
 * The broad phase: which boxes may touch. {@link org.jbox2d.collision.broadphase.BroadPhase} finds
 * pairs of moved proxies in a {@link org.jbox2d.collision.broadphase.BroadPhaseStrategy}, by
 * default the tree of {@link org.jbox2d.collision.broadphase.DynamicTreeFlatNodes}.
 */
package org.jbox2d.collision.broadphase;
