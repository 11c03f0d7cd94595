"""The layout layer: written from layouts, drawn, read back and checked."""
