# $lines = 5
# $n = 14
# $height_m = 73.0
# $pixel_mm = 20.0
flight-lines = Flight: { $lines } { $lines ->
        [one] line
        *[other] lines
    } of { $n } photographs, { NUM($height_m, digits: 4) } m above ground; pixel { $pixel_mm } mm.

# $along = 0.8
# $across = 0.7
# $width_m = 100.0
# $length_m = 150.0
flight-overlap = Overlap: { PERCENT($along) } % along, { PERCENT($across) } % across. Tie points over { $width_m } x { $length_m } m.

# $base_m = 14.6
# $spacing_m = 32.8
flight-spacing = Base { $base_m } m, line spacing { $spacing_m } m.

# $sigma_m = [0.02, 0.02, 0.03]
# $rtk = true
flight-positions = Standard deviations of positions: { $sigma_m } m ({ $rtk ->
        [yes] RTK
        *[no] no RTK
    }).

# $x = "12 mm"
# $y = "12 mm"
# $z = "31 mm"
# $known = true
# $c_px = 0.4
flight-precision = Predicted sigma (rms): X { $x }, Y { $y }, Z { $z }; c { $known ->
        [yes] { NUM($c_px, digits: 2) } px
        *[no] not determinable
    }.

flight-determined = All parameters are determined by design.

flight-layouts = Layouts of five control points of 10 mm:

# $n = 9
# $of = 400
flight-thinned = { $n } photographs in the middle represent { $of }.

# $rtk = true
# $sigma_m = [0.02, 0.02, 0.03]
# $held = false
# $plan = "12 mm"
# $height = "31 mm"
# $c = "0.4 px"
# $n_lost = 0
# $lost = []
flight-predicted = Predicted without control, { $rtk ->
        [yes] RTK
        *[no] no RTK
    } ({ $sigma_m } m{ $held ->
        [yes] , lever arm held
        *[no] {""}
    }): plan { $plan }, height { $height }, c { $c }{ $n_lost ->
        [0] {""}
        *[other] ; not determinable: { $lost }
    }.

# $kind = "control"
# $n = 1
flight-mend = Determined by: { $kind ->
        [tilted-grid] views tilted by 20 deg ({ OPTION("pattern", "double-grid") } { OPTION("tilt", "20") })
        [oblique-grid] oblique views beside vertical ones ({ OPTION("pattern", "oblique-grid") })
        [again] the lines flown once more with the view tilted ahead by 30 deg
        [turned] the rows flown once more with the view turned left and right by 30 deg
        *[control] control
    }{ $n ->
        [0] {""}
        [one] {" "}and one control point
        *[other] {" "}and { $n } control points
    }.

# $sigma_mm = 10.0
# $n = 5
# $known = true
flight-control_enough = Control points of { $sigma_mm } mm: { $known ->
        [no] { $n } do not determine all parameters.
        *[yes] { $n ->
            [0] none improves the worst height by 10 %.
            *[other] { $n } are enough; more improve the worst height by less than 10 %.
        }
    }

# $camera = "Mavic 3E"
# $width_px = 5280
# $height_px = 3956
# $c_px = 3700.0
flight-camera = Camera: { $camera } ({ $width_px } x { $height_px } px, c = { NUM($c_px, decimals: 0) } px).

flight-standing = The vehicle stops for each photograph.

# $speed = 8.2
# $interval_s = 1.8
# $blur_px = 0.4
# $exposure = 1000
flight-motion = Speed { NUM($speed, decimals: 1) } m/s, interval { NUM($interval_s, decimals: 2) } s, motion blur { NUM($blur_px, decimals: 2) } px at 1/{ $exposure } s.

# $least = 3
# $middle = 9
flight-coverage = Photographs of a place of the area: at least { $least }, median { $middle }.

# $photographs = 120
# $lines = 6
# $way_points = 24
# $pattern = "nadir"
# $vehicle = "mavic-3e"
flight-mission = Mission ({ $pattern }, { $vehicle }): { $photographs } photographs, { $lines } lines, { $way_points } way points.

# $pixel = "20"
# $asked = "20"
# $above = "75.0"
# $along = "80 %"
# $across = "70 %"
flight-ground = Pixel { $pixel } mm ({ $asked } required), { $above } m above ground; overlap { $along } along, { $across } across.

# $way_km = 2.4
# $n = 1
# $minutes = [7.5]
# $usable = 30.0
# $farthest_m = 310.0
flight-batteries = Way { NUM($way_km, decimals: 2) } km, { $n } { $n ->
        [one] battery
        *[other] batteries
    } ({ $minutes } of { $usable } min), up to { NUM($farthest_m, decimals: 0) } m from the take-off.
