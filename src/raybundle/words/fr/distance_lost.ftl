distance_lost = { $n } distance(s) ne participent pas : des points image des extrémités ont été rejetés ({ $ids }).
