# $n = 2
# $names = ["M3", "M7"]
marks_left_out = { $n } marked { $n ->
        [one] point is
       *[other] points are
    } not in the adjustment: { $names }.
    .why = A point needs marks in two oriented photographs.
    .do = Mark them in further photographs.
