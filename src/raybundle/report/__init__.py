"""Reports and result folders."""
