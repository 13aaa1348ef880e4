# $camera = "d5100"
# $n = 1
# $limit = 1.2
# $ids = ["d5100", "c"]
calibration_outweighed = Camera { $camera }: the result determines it less precisely than the given calibration (limit { NUM($limit, digits: 2) } times).
    .why = The observations are weighted as if their errors were independent, and pull the camera from better known values.
    .do = Hold the calibration (estimate = []).

# $symbol = "x0"
# $before = 0.0005
# $after = 0.002
calibration_outweighed-parameter = Parameter { $symbol }: standard deviation { NUM($before, digits: 2) } as given, { NUM($after, digits: 2) } in the result.
