"""Coded targets: families and their codes, detection, centres with covariances, sheets, boards."""
