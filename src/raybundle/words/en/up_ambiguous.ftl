# $kind = "terrestrial"
# $probability = 0.7
# $limit = 0.95
up_ambiguous = The vertical is ambiguous: the set is { $kind ->
     [terrestrial] terrestrial
     [aerial] aerial
     *[oblique] oblique
    } with a probability of { PERCENT($probability) } % only (limit { PERCENT($limit) } %).
    .why = It is treated as such, from how the photographs were held.
    .do = If the result lies on its side, give { OPTION("up", "terrestrial") }, { OPTION("up", "aerial") }, or two points with B plumb above A: { OPTION("up", "A,B") }.
