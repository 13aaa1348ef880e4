# $parts = 2
# $photographs = [40, 12]
parts_joined = { $parts } parts of the block ({ $photographs } photographs) have no common points.
    .why = Control or positions join them.
    .do = Take photographs that show two parts at once, for a stronger joint.
