# $limit = 0.42
# $unit = "mm"
sigma_class-above = above { NUM($limit, digits: 2) } { $unit }

# $sigma = 0.42
# $unit = "mm"
sigma_class-all = all { NUM($sigma, digits: 2) } { $unit }

# $place = "below"
# $limit = 1.4
# $unit = "mm"
sigma_class-by_wanted = { $place ->
        [far_below] far below
        [below] below
        [just_below] just below
        *[above] above
    } it: to { NUM($limit, digits: 2) } { $unit }

sigma_class-far_above = far above it

sigma_class-head = standard deviation of a coordinate

# $wanted = 2.0
# $unit = "mm"
sigma_class-head_wanted = standard deviation of a coordinate; wanted: { NUM($wanted, digits: 3) } { $unit }

# $limit = 0.42
# $unit = "mm"
sigma_class-to = to { NUM($limit, digits: 2) } { $unit }

# $sigma = 0.93
# $unit = "mm"
sigma_class-worst = worst: { NUM($sigma, digits: 3) } { $unit }
