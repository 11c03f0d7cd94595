"""What layouts are worth: how good one is, what changed from one to the next, and what that
saved."""
