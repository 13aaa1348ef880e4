error-other = Cause : { $detail }
