# $source = "eo.txt"
# $reading = "opk-gon"
# $other = "opk-deg"
# $scatter_deg = 0.01
# $other_deg = 8.2
attitudes_reading = The photographs decide: the attitudes of { $source } are { $reading }.
    .why = Scatter against the photographs: { NUM($scatter_deg, decimals: 3) }° as { $reading }, { NUM($other_deg, decimals: 3) }° as { $other }.
