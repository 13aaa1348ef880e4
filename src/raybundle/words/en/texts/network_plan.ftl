# $name = "facade:12,8"
network_plan-title = Plan: { $name }

# $sigma_px = 0.1
network_plan-promise = Standard deviations are those expected of the plan, with { NUM($sigma_px) } px of image points.

# $control = 4
# $bars = 2
network_plan-frame = { $control ->
        [0] They are relative to all points together{ $bars ->
            [0] .
            *[other] , with the scale of the scale bars and its error.
        }
        *[other] They are in the frame of { $control } control { $control ->
            [one] point
            *[other] points
        }{ $bars ->
            [0] .
            [one] {" "}and { $bars } scale bar.
            *[other] {" "}and { $bars } scale bars.
        }
    }{ $control ->
        [0] { $bars ->
            [0] {" "}A scale bar or control gives the scale, and adds its own error.
            *[other] {""}
        }
        *[other] {""}
    }

network_plan-grey = Grey parts of the object are in fewer than two photographs.

# $control = true
# $bar = true
network_plan-known = { $control ->
        [yes] control{ $bar ->
            [yes] , scale bar
            *[no] {""}
        }
        *[no] scale bar
    }

# $n = 4
# $side = "top"
network_plan-points_unseen = { $n } { $n ->
        [one] point
        *[other] points
    } { $side ->
        [top] on top
        [below] below
        [front] in front (towards -Y)
        [back] behind (towards +Y)
        [right] on the right (towards +X)
        *[left] on the left (towards -X)
    } would be found less than twice without it.

network_plan-undetermined = Without it the network is not determined.

# $what = "worst"
# $size = "per_cent"
# $per_cent = 12.3
# $ratio = 1.123
network_plan-larger = { $what ->
        [worst] Worst sigma
        [mean] Mean sigma
        [calibration] Uncertainty of the calibration
        [reliability] Worst check of an image point
        [top] On top: sigma
        [below] Below: sigma
        [front] In front (towards -Y): sigma
        [back] Behind (towards +Y): sigma
        [right] On the right (towards +X): sigma
        [left] On the left (towards -X): sigma
        *[parameter] { $what }
    } without it { $size ->
        [hardly] hardly determined
        [times] { NUM($ratio, decimals: 0) } times as large
        *[per_cent] { NUM($per_cent, decimals: 0) } % larger
    }.

# $photographs = 10
# $points = 120
# $sigma_px = 0.05
network_plan-about = planned: { $photographs } photographs of { $points } points, image points of { $sigma_px } px
