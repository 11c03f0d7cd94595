"""usdrigui's own mathematics of drags and rotations, put here when the extension is built."""
