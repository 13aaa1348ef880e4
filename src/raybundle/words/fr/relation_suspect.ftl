relation_suspect = { suspect-value }
