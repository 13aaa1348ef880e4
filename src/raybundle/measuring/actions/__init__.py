"""The verbs of measuring, each with its checks."""
