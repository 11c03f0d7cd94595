"""The board: elements that do not stand on the face, in a tidy grid."""
