# $head = "QGC WPL 110"
wpl-no_header = The first line is not { $head }; this is not a list of way points.
    .do = Check that it is the right file.
