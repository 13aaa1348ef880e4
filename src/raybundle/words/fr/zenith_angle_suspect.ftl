zenith_angle_suspect = { suspect-value }
