"""The web viewer: characters and layouts as one page, and the server of a live one."""
