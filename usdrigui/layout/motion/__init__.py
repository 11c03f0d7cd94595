"""How the points of a face move under each control, and how alike these motions are (paper section
3.1)."""
