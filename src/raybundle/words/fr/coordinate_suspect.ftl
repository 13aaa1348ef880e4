coordinate_suspect = { suspect-value }
