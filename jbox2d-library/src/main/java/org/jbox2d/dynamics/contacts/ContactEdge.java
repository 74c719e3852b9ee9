package org.jbox2d.dynamics.contacts;

import org.jbox2d.dynamics.Body;

/** A node in the list of contacts of a body. Each contact has two, one for each body. */
public class ContactEdge {
  /** The body at the other end. */
  public Body other;

  /** The contact. */
  public Contact contact;

  /** The previous node of the body's list, or {@code null}. */
  public ContactEdge prev;

  /** The next node of the body's list, or {@code null}. */
  public ContactEdge next;

  /** A node that is in no list. */
  public ContactEdge() {}
}
