"""usdrigui's own mathematics of drags and rotations, copied here when the extension is built."""
