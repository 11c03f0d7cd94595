"""What the character itself looks like: its colours, and its surface in their light."""
