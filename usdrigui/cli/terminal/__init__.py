"""How a run looks on a terminal, and in a log: progress, tables and the closing line."""
