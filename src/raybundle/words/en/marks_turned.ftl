# $table = "control.csv"
# $marks = 12
# $photographs = 4
# $orientations = [6]
# $before_px = 800.0
# $after_px = 1.2
# $compared = true
# $outside = false
# $ids = ["control.csv"]
marks_turned = { $marks } { $marks ->
     [one] mark
     *[other] marks
    } of { $table } measured in photographs as a viewer turns them; turned back.
    .why = { $photographs } { $photographs ->
     [one] photograph has
     *[other] photographs have
    } EXIF orientation { LIST($orientations, most: 8) }.{ $outside ->
     [yes] { "" } As stored, the marks are outside the format.
     *[no] { "" }
    }{ $compared ->
     [yes] { "" } As stored they deviate by { $before_px } px, turned back by { $after_px } px (median).
     *[no] { "" }
    }
    .do = Measure in the pixels as stored, with a program that ignores the EXIF orientation.

# $table = "control.csv"
# $marks = 4
# $photographs = 2
# $orientations = [6]
# $before_px = 800.0
# $after_px = 1.2
# $compared = true
# $limit_px = 15.0
# $before_near = 0
# $after_near = 2
# $ids = ["control.csv"]
marks_turned-undecided = { $marks } { $marks ->
     [one] mark
     *[other] marks
    } of { $table } may be measured in photographs as a viewer turns them; not changed.
    .why = { $photographs } { $photographs ->
     [one] photograph has
     *[other] photographs have
    } EXIF orientation { LIST($orientations, most: 8) }.{ $compared ->
     [yes] { "" } As stored they deviate by { $before_px } px, turned back by { $after_px } px (median, limit { $limit_px } px).
     *[no] { "" }
    } Within the limit are { $before_near } and { $after_near }.
    .do = Measure in the pixels as stored, or mark more points in three photographs or more.
