# $photographs = 18
# $lines = 3
# $drift = true
relative_control = Positions of { $photographs } photographs on { $lines } flight lines are used by their differences{ $drift ->
        [yes] {" "}(with drift)
       *[no] {""}
    }.
    .why = A constant error of the positions of a line then does not distort the block.
    .do = For the absolute position, give at least three control points.

# $n = 4
relative_control-excluded = { $n } { $n ->
        [one] photograph
       *[other] photographs
    } on no flight line { $n ->
        [one] is
       *[other] are
    } excluded.

# $axes = ["X", "Y"]
# $plan_m = 5.0
# $height_m = 10.0
relative_control-open = Without control in { $axes }, the shift of a line is assumed good to { $plan_m } m in plan, { $height_m } m in height.
