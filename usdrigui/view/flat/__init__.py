"""A picture as a flat scene: marks, words and leaders placed once, drawn by Pillow or as SVG."""
