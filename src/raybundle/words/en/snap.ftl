snap-no_reference = A patch needs the same point in another picture.
    .do = Mark the point in one picture first.

# $kind = "'star'"
snap-unknown_kind = Kind { $kind } is unknown.
    .do = Use ellipse, corner, cross, patch or auto.

# $kind = "float64"
# $shape = [100, 200, 3]
snap-image_type = A picture of type { $kind } and shape ({ $shape }) cannot be measured.
    .do = Give a grey picture of 8 or 16 bits.

# $x_px = -5.0
# $y_px = 10.0
# $width_px = 200
# $height_px = 100
snap-outside = x = { $x_px }, y = { $y_px } is outside the picture of { $width_px } x { $height_px } px.
    .do = Give a place within it.

# $reach_px = -1.0
# $most_px = 64
snap-reach = reach_px = { $reach_px } is not possible.
    .do = Give a value above 0 and at most { $most_px }.
