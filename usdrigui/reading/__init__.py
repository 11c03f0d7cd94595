"""From a stage to `Rig` records: a file for each thing that a rigger names."""
