# $start = "A"
# $end = "B"
# $length_m = "-1"
scale_bar-length = Scale bar { $start } - { $end }: the length is { $length_m } m.
    .do = Give it in metres, above 0.

# $start = "A"
# $end = "B"
# $sigma_m = "0"
scale_bar-sigma = Scale bar { $start } - { $end }: the standard deviation is { $sigma_m } m.
    .do = Give it in metres, above 0.

# $start = "A"
# $end = "B"
scale_bar-too_few_rays = Scale bar { $start } - { $end }: its end points need two or more rays each.
    .do = Measure them in more photographs.

# $start = "A"
# $end = "B"
# $point = "B"
scale_bar-end_not_measured = Scale bar { $start } - { $end }: point { $point } is not measured in any photograph.
    .do = Give its image measurements with { OPTION("control") }, or detect targets with { OPTION("target") }.
