"""The board: elements off the face, in a tidy grid."""
