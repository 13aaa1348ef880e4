plane_suspect = { suspect-value }
