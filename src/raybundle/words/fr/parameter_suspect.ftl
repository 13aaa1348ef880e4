parameter_suspect = { suspect-value }
