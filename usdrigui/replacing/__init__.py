"""Files that are replaced whole or not at all: whatever fails or is killed, the old or the new one
is there, complete, and what is left beside it is nobody's and goes with the next run.

`transaction` writes the files of a run, `exchange` puts an edited source into the place of the
one that was read, `temporaries` are what both write first.
"""
