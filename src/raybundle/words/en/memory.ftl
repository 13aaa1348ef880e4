# $size_mb = 5200.0
# $detail = "No space left on device"
memory-no_room = No space for an array of { $size_mb } MB ({ $detail }).
    .do = Free disk space, or allow more memory.
