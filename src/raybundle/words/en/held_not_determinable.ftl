# $n = 1
# $ids = ["d5100"]
held_not_determinable-cameras = The points do not determine the interior orientation of { $ids }; its approximate values are held.
    .why = Standard deviations are valid for these values only.
    .do = Measure more points.
