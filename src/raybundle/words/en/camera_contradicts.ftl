# $camera = "d5100"
# $squares = 45.0
# $n = 2
# $limit = 13.8
# $level_percent = 0.1
# $ids = ["d5100"]
camera_contradicts = Camera { $camera }: the interior orientation found is impossible for this camera.
    .why = Orientations and their standard deviations are not reliable (chi-square { NUM($squares, decimals: 0) } of { $n }, limit { NUM($limit, decimals: 1) } at { $level_percent } %).
    .do = Give { OPTION("calibration") }, also for cropped photographs or an unusual lens, or take convergent and rolled photographs.

# $symbol = "x0"
# $found_px = 900.0
# $known_px = 0.0
# $known_sigma_px = 13.0
camera_contradicts-value = Parameter { $symbol }: { NUM($found_px, decimals: 0) } px found, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px known.

# $symbol = "c"
# $found_px = 9000.0
# $known_px = 768.0
# $factor = 1.5
camera_contradicts-factor = Parameter { $symbol }: { NUM($found_px, decimals: 0) } px found, { NUM($known_px, decimals: 0) } px known to a factor of { $factor }.

# $camera = "d5100"
# $x_px = 22.0
# $y_px = 14.0
# $width_px = 4928
# $height_px = 3264
camera_contradicts-millimetres = Camera { $camera }: its image points seem to be in mm, not in pixels.
    .why = They extend over { $x_px } x { $y_px }, as the format does in mm; it has { $width_px } x { $height_px } px.
    .do = Give pixels from the upper left corner.

# $sigma0 = 1.1
# $sigma0_given = 12.0
camera_contradicts-pixels = The pixels do not have the given shape: sigma0 is { $sigma0 } with another height, { $sigma0_given } as given.
    .do = Check pixel_mm, and whether images were resampled. Heights relative to those given:

# $camera = "d5100"
# $factor = 1.067
camera_contradicts-pixel_height = Camera { $camera }: the pixel height is { NUM($factor, digits: 5) } times the given one.
