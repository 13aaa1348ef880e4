# $turn_deg = 150.0
# $corner = 4
# $most_deg = 120.0
corridor-sharp_turn = The line turns by { NUM($turn_deg, decimals: 0) }° at corner { $corner } (limit { NUM($most_deg, decimals: 0) }°).
    .do = Plan the two parts as separate corridors.

# $corner = 4
# $offset_m = 40.0
# $length_m = 12.0
corridor-tight_bend = The bend at corner { $corner } is too tight for a flight line { NUM($offset_m, decimals: 1) } m beside the line.
    .why = The part there is { NUM($length_m, decimals: 1) } m long.
    .do = Delete the corner, or give a narrower corridor: { OPTION("width") }.
