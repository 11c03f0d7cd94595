"""What a run found out, as records and as documents: `run_report` of `process`, `inspection` of
`inspect`."""
