/** The documents in Markdown are held to what they say: snippets, coordinates, commands, links. */
package org.jbox2d.documentation;
