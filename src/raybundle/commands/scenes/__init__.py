"""What `raybundle rpc` does with scenes: correct them, many at once, and bring them to the map."""
