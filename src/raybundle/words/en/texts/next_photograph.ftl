# $goal = "worst"
# $before = 0.42
# $before_known = true
# $before_unit = "mm"
# $after = 0.31
# $after_known = true
# $after_unit = "mm"
# $alike = false
# $less = 0.0
next_photograph-brings = { $goal ->
        [worst] Largest sigma
        [mean] Mean sigma
        [points] Largest sigma of the chosen points
        *[calibration] Largest uncertainty of projection
    }: { $after_known ->
        [yes] { NUM($after, digits: 2) } { $after_unit ->
            [units] units
            *[other] { $after_unit }
        }
        *[no] not determinable
    }{ $alike ->
        [yes] , { PERCENT($less, digits: 1) } % less
        *[no] {" "}instead of { $before_known ->
            [yes] { NUM($before, digits: 2) } { $before_unit ->
                [units] units
                *[other] { $before_unit }
            }
            *[no] not determinable
        }
    }.

# $parameters = ["c 12 %"]
next_photograph-brings_parameters = Smaller standard deviations: { $parameters }.

# $point = "T7"
# $before = 0.42
# $before_known = true
# $before_unit = "mm"
# $after = 0.31
# $after_known = true
# $after_unit = "mm"
# $alike = false
# $less = 0.0
next_photograph-brings_point = Point { $point }: { $after_known ->
        [yes] { NUM($after, digits: 2) } { $after_unit ->
            [units] units
            *[other] { $after_unit }
        }
        *[no] not determinable
    }{ $alike ->
        [yes] , { PERCENT($less, digits: 1) } % less
        *[no] {" "}instead of { $before_known ->
            [yes] { NUM($before, digits: 2) } { $before_unit ->
                [units] units
                *[other] { $before_unit }
            }
            *[no] not determinable
        }
    }.

# $camera = "d5100"
next_photograph-camera = Camera { $camera }:

# $goal = "worst"
next_photograph-goal = { $goal ->
        [worst] largest sigma
        [mean] mean sigma
        [points] largest sigma of the chosen points
        *[calibration] largest uncertainty of projection
    }

# $upside_down = false
# $against = false
# $name = "12"
next_photograph-hold = { $against ->
        [yes] { $upside_down ->
            [yes] Hold the camera upside down against photograph { $name }.
            *[no] Hold the camera as for photograph { $name }.
        }
        *[no] { $upside_down ->
            [yes] Hold the camera upside down.
            *[no] Hold the camera upright.
        }
    }

# $name = "12"
# $sideways = "right"
# $sideways_deg = 20
# $upwards = "none"
# $upwards_deg = 0
next_photograph-look = Look { $sideways ->
        [none] {""}
        [right] { $sideways_deg } degrees to the right
        *[left] { $sideways_deg } degrees to the left
    }{ $sideways ->
        [none] {""}
        *[other] { $upwards ->
            [none] {""}
            *[other] {" "}and{" "}
        }
    }{ $upwards ->
        [none] {""}
        [up] { $upwards_deg } degrees up
        *[down] { $upwards_deg } degrees down
    } of the view of photograph { $name }.

# $near = false
# $named = true
# $point = "T7"
# $image = "12"
# $x_px = 1200
# $y_px = 800
next_photograph-middle = { $near ->
        [yes] Near the middle
        *[no] In the middle
    } of the picture: { $named ->
        [yes] point { $point }
        *[no] what photograph { $image } shows at { $x_px }, { $y_px } px
    }.

# $name = "12"
# $known = true
# $unit = "m"
# $first = "left"
# $second = "higher"
# $third = "none"
# $one = 3.0
# $two = 0.5
# $three = 0.0
next_photograph-place = From photograph { $name } go { $known ->
        [yes] { NUM($one, digits: 2) } { $unit }
        *[no] { NUM($one, digits: 2) }
    } { $first ->
        [right] to the right
        [left] to the left
        [upper_edge] towards its upper edge
        [lower_edge] towards its lower edge
        [higher] higher
        [lower] lower
        [nearer] nearer
        *[farther] farther back
    }{ $second ->
        [none] {""}
        *[other] , { $known ->
            [yes] { NUM($two, digits: 2) } { $unit }
            *[no] { NUM($two, digits: 2) }
        } { $second ->
            [right] to the right
            [left] to the left
            [upper_edge] towards its upper edge
            [lower_edge] towards its lower edge
            [higher] higher
            [lower] lower
            [nearer] nearer
            *[farther] farther back
        }
    }{ $third ->
        [none] {""}
        *[other] , { $known ->
            [yes] { NUM($three, digits: 2) } { $unit }
            *[no] { NUM($three, digits: 2) }
        } { $third ->
            [right] to the right
            [left] to the left
            [upper_edge] towards its upper edge
            [lower_edge] towards its lower edge
            [higher] higher
            [lower] lower
            [nearer] nearer
            *[farther] farther back
        }
    }{ $known ->
        [yes] {""}
        *[no] {" "}(1: distance from there to the object)
    }.

next_photograph-predicted = Standard deviations with the proposals; image points as precise as now.

# $name = "next-1"
next_photograph-proposal = { $name }:

# $angle_deg = 90
# $clockwise = true
# $against = false
# $name = "12"
next_photograph-roll = Roll the camera by { $angle_deg } degrees { $clockwise ->
        [yes] clockwise
        *[no] anticlockwise
    } about its viewing axis, { $against ->
        [yes] against photograph { $name }
        *[no] { $clockwise ->
            [yes] right
            *[no] left
        } side down
    }.

# $name = "12"
next_photograph-same_place = Stand where photograph { $name } was taken.

# $points = ["T1", "T2"]
# $more = 23
next_photograph-shows = It must show { $points }{ $more ->
        [0] {""}
        [one] {" "}and { $more } other point
        *[other] {" "}and { $more } other points
    }.

# $n = 120
next_photograph-shows_tie_points = It shows { $n } tie { $n ->
        [one] point
        *[other] points
    }.

# $n = 2
next_photograph-about = { $n } { $n ->
        [one] photograph
        *[other] photographs
    } proposed, with predicted image points
