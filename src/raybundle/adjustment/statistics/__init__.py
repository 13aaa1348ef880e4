"""What the factor of the last step yields: precision, reliability, noise, interior orientation, network."""
