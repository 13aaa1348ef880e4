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

# $start = "M1"
# $end = "M2"
# $length_m = 1.0
# $sigma_m = 2.0
scale_bar-sigma_too_large = Scale bar { $start } - { $end }: the standard deviation { $sigma_m } m exceeds the length { $length_m } m.
    .do = Give both in metres.

# $start = "M1"
# $end = "M2"
scale_bar-no_length = Scale bar { $start } - { $end }: its ends are one point or have no coordinates.
    .do = Correct the names of the ends.

# $factor = 1000.0
# $exchanged = true
# $first = "M1 - M2"
# $second = "M3 - M4"
scale_bar-contradict = Scale bars contradict each other by a factor of { $factor }.
    .why = { $exchanged ->
        [yes] With the lengths of { $first } and { $second } exchanged they agree.
       *[no] { "" }
     }
    .do = { $exchanged ->
        [yes] Check whether the certificates of the two were exchanged
       *[no] Give lengths in metres, and check the names of the ends
     }.

# $bar = "M1 - M2"
# $given_m = 1.2
# $measured_m = 0.0012
# $others = "M3 - M4"
# $pair = true
scale_bar-given_and_measured = Scale bar { $bar }: given { NUM($given_m, digits: 6) } m, by { $pair ->
        [yes] { $others }
        *[no] the other bars
    } { NUM($measured_m, digits: 6) } m.
