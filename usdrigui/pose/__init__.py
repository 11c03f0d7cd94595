"""Posing a laid-out character: elements at a pose and drags of handles; numpy only."""
