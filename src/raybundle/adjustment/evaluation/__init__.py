"""What a finished adjustment shows: covariances, structure of residuals, further standard deviations."""
