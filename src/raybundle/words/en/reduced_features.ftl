# $size_px = 1600
# $oriented = 38
# $photographs = 40
# $whole = 12
reduced_features = Features are from copies reduced to { $size_px } px: these orient { $oriented } of { $photographs } photographs.
    .why = Features at full size orient { $whole }: the photographs are soft, noisy or heavily compressed.
