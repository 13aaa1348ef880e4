flight_change-planned = as planned

# $lever_arm = true
flight_change-without_rtk = the same without RTK{ $lever_arm ->
        [yes] , lever arm held
        *[no] {""}
    }

flight_change-headings = headings alternate

# $n = 5
flight_change-control = { $n ->
        [1] one control point in the middle
        *[5] five control points
    }

# $times = 1.3
flight_change-across_higher = lines across, { $times } times as high

# $tilt_deg = 30.0
# $headings = true
# $control = 5
flight_change-across_tilted = lines across, tilted { NUM($tilt_deg) } deg{ $headings ->
        [yes] , headings alternate
        *[no] {""}
    }{ $control ->
        [0] {""}
        [1] , one control point
        *[5] , five control points
    }

# $where = "corners"
flight_change-places = { $where ->
        [two_corners] two corners, middle of the opposite edge
        [corners] corners and middle
        [edges] corners, edges, middle
        [between] corners, edges, middle, and four between
        [one_edge] along one edge
        *[middle] round the middle
    }
