# $n = 20
# $before_m = 120.0
# $after_m = 0.4
# $ids = ["IMG_1"]
positions_unit = The heights of the positions seem to be in feet; no position is used.
    .why = The { $n } positions fit the photographs to { NUM($before_m, digits: 2) } m as given, and to { NUM($after_m, digits: 2) } m in metres.
    .do = Give heights in metres (feet times 0.3048).
