"""Which controls are on the face and which on the board (paper sections 3.3 and 4.2)."""
