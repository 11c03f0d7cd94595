"""What earlier layouts ask of a new one: the previous, another character's, the existing, and fixed
anchors."""
