"""A layout among the sublayers or payloads of its asset: the one edit of a source."""
