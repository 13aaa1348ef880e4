# $n = 2
similarity-too_few_points = A similarity transformation needs three common points; { $n } { $n ->
        [one] is
       *[other] are
     } given.
    .do = Give three or more points with coordinates in both systems, and not on one line.

similarity-points_in_line = The common points of the similarity transformation lie in one line.
    .why = The rotation about this line is not determined.
    .do = Add a point beside the line.
