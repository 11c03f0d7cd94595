"""Posing a laid-out character: direct manipulation and drags; numpy only."""
