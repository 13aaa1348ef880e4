station_suspect = { suspect-value }
