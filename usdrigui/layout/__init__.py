"""The stages that turn a rig into a layout problem, and an assignment into a layout."""
