"""Scanned film: fiducial marks, certificates of metric cameras."""
