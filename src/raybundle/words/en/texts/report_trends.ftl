report_trends-title = Velocities

# $name = "area 3"
# $first = "2026-05-01"
# $last = "2026-08-01"
# $verdict = "constant"
report_trends-figure = { $name }, { $first } to { $last }: displacement, standard deviation; line: { $verdict ->
        [constant] constant velocity
       *[other] constant acceleration
    }.

report_trends-velocity = velocity

report_trends-acceleration = acceleration

report_trends-motion = motion

# $verdict = "constant"
report_trends-motion_of = { $verdict ->
        [constant] constant
        [accelerated] accelerated
        [decelerated] decelerated
       *[irregular] irregular
    }

# $limit = 0.01
report_trends-note = p: of the residuals at a constant velocity; below { NUM($limit, digits: 2) } the motion is not constant. a: year.
