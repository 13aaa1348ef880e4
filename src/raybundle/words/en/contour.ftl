# $n = 20000
# $most = 10000
contour-too_many_levels = The heights span { $n } contour levels; at most { $most } are drawn.
    .do = Choose a larger interval.
