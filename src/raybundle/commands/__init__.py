"""What the command line and Python can ask for alike: one frozen data class of settings a command, and what it does.

Of the fields are made: the options of the command line with their help, the keyword arguments in Python, and the
section of the project file.
"""
