attitude_suspect = { suspect-value }
