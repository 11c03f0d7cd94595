"""The parts of a character, each with a scale, a front, mirror pairs and a layout problem of its
own."""
