level_suspect = { suspect-value }
