"""One module a set; what it has is stated in `demonstrations`."""
