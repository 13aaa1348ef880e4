# $n = 18
# $plan_m = 5.0
# $height_m = 10.0
positions_assumed = { $n } { $n ->
     [one] position has
     *[other] positions have
    } no standard deviation; { $plan_m } m in plan and { $height_m } m in height are assumed.
    .do = Give the standard deviations in the file of positions if they are known.
