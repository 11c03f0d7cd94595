"""Processes with limits that answer one question, and the door through which foreign files come.

A command runs in a worker below a supervisor (decision 080), and what nobody has vouched for is
read by a confined reader below that.
"""
