"""Foreign USD is read in a process that may be lost: what it is asked, does and answers."""
