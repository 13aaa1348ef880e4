# $detail = "disk quota exceeded"
error-other = Cause: { $detail }
