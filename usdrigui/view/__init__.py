"""Pictures and the web viewer, made from a written layer."""
