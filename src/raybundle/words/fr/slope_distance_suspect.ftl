slope_distance_suspect = { suspect-value }
