direction_suspect = { suspect-value }
