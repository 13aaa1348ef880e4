plumb_line_suspect = { suspect-value }
