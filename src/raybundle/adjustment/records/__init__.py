"""Data that all parts of an adjustment share: settings, notices, statistics as plain data."""
