# $detail = "disk quota exceeded"
error-other = Cause: { $detail }
    .do = Remove this cause, then run the command again.
