"""A robot that learns a task by being told what it is, shown it once and corrected by voice."""
