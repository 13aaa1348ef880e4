# $value = 411.0
# $limit = 180.0
position-beyond_degrees = { NUM($value, digits: 10) }° is outside ± { $limit }°.
    .do = Check whether longitude and latitude are interchanged.
