# $point = "P12"
# $rays = 2
marked_lost = Marked point { $point } is not in the result: its { $rays } rays are parallel or do not intersect.
    .do = Check its marks, and mark it in photographs from other places.
