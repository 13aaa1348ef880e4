# $n = 1
# $part = "scale"
# $kind = "control"
# $ids = ["A", "B"]
control_leaves_open = Not determined by the { $kind ->
        [centres] observed projection centres
        [both] control points and projection centres
       *[control] control points
     }: { datum-part }.
    .why = Coordinates have no meaning in that direction ({ $ids }).
    .do = Measure more control points.

# $n = 1
# $part = "about_line"
# $kind = "control"
# $ids = ["A", "B"]
control_leaves_open-line = The { $kind ->
        [centres] observed projection centres
        [both] control points and projection centres
       *[control] control points
     } lie on one line; the rotation about it is not determined.
    .why = Coordinates have no meaning in that direction ({ $ids }).
    .do = Measure a control point beside this line.

# $n = 1
# $part = "about_line"
# $kind = "control"
# $width = 0.12
# $sigma = 0.1
# $unit = "m"
# $ids = ["A", "B"]
control_leaves_open-imprecise = The { $kind ->
        [centres] observed projection centres
        [both] control points and projection centres
       *[control] control points
     } are too imprecise for the rotation about their line.
    .why = They lie { NUM($width, digits: 2) } { $unit } (rms) off this line, with standard deviations of { NUM($sigma, digits: 2) } { $unit } ({ $ids }).
    .do = Measure them more precisely, above all their heights.
