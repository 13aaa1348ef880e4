# $value = "before"
# $rim = "rim"
volume-base_unknown = { OPTION("above", $value) } is neither a height, the folder of a surface, nor { $rim }.
    .do = Give one of these.

volume-rim_needs_outline = A base along the rim needs an outline.
    .do = Give { OPTION("outline", "FILE") }, or { OPTION("above", "HEIGHT") }.

# $share = 0.21
# $limit_percent = 10.0
volume-filled_share = { PERCENT($share) } % of the area was filled (limit { $limit_percent } %).
    .do = Photograph the gaps, or allow it with { OPTION("most_filled", 100) }.

# $share = 0.012
# $n = 48
# $x = 5012.25
# $y = 2034.5
# $distance = 0.8
# $unit = "m"
# $fill = "1.6"
volume-no_height = { PERCENT($share) } % of the area has no height ({ $n } { $n ->
        [one] cell
       *[other] cells
     }).
    .why = The middle of the widest hole, at X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }, is { $distance } { $unit } from a height.
    .do = Fill it with { OPTION("fill", $fill) }, or exclude it from the outline.
