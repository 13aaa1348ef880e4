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
camera_contradicts-value = { $symbol }: { NUM($found_px, decimals: 0) } px found, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px known

# $symbol = "c"
# $found_px = 9000.0
# $known_px = 768.0
# $factor = 1.5
camera_contradicts-factor = { $symbol }: { NUM($found_px, decimals: 0) } px found, { NUM($known_px, decimals: 0) } px known to a factor of { $factor }
