"""Many assets, each laid out by a process of its own, here or on a cluster; unchanged ones are
skipped."""
