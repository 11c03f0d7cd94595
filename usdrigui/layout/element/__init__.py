"""From a solution to the elements that an animator sees (paper section 3.2)."""
