noise_in_parts = Standard deviations are based on white noise: noise fields need the normal equations in one piece.
    .why = With photographs such standard deviations are too small.
    .do = Allow more memory ({ OPTION("memory", "GB") }), or multiply the standard deviations.

# $of = "interior"
# $factor = 4.2
# $images = 40
noise_in_parts-factor = { $of ->
        [interior] Interior orientation
       *[points] Object points
    }: factor { NUM($factor, digits: 2) } (median, in a part of { $images } images adjusted separately).
