"""Pictures rendered of made objects: boards, ground, parts."""
