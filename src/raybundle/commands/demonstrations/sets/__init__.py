"""One module a set; what it has is said in `demonstrations`."""
