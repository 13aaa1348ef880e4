deviation_suspect = { suspect-value }
