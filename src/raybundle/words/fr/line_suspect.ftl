line_suspect = { suspect-value }
