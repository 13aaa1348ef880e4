# $n = 1
# $ids = ["d5100"]
held_not_determinable-cameras = The points do not determine the interior orientation of { $ids }; its approximate values are held.
    .why = Standard deviations are valid for these values only.
    .do = Measure more points.

# $camera = "d5100"
# $symbol = "K2"
# $at = 0.0
# $unit = "mm"
# $ids = ["d5100", "K2"]
held_not_determinable = Camera { $camera }: { $symbol } is not determinable and was held at its known value { NUM($at, digits: 4) } { $unit }.
    .why = The result is valid for this value; an error of the value distorts coordinates without larger residuals.
    .do = Add convergent and rolled photographs, or give a calibration.

# $sigma = 0.2
# $unit = "mm"
# $effect_px = 12.0
held_not_determinable-sigma = The standard deviation of this parameter would be { NUM($sigma, digits: 2) } { $unit }, { NUM($effect_px, decimals: 0) } px in the image.

# $cameras = 1
# $n = 2
# $ids = ["d5100", "c", "x0"]
held_not_determinable-known_before = { $n } camera { $n ->
        [one] parameter is
       *[other] parameters are
     } held by prior knowledge, not by the photographs ({ $cameras } { $cameras ->
        [one] camera
       *[other] cameras
     }).
    .why = Orientations and coordinates depend on these assumed values.
    .do = Give a calibration.

# $camera = "d5100"
# $symbols = ["c", "x0"]
held_not_determinable-parameters = Camera { $camera }: held parameters are { LIST($symbols, most: 10) }.

# $camera = "d5100"
# $symbol = "x0"
# $known_px = 0.0
# $known_sigma_px = 13.0
# $found_px = 2.0
# $sigma_px = 12.0
held_not_determinable-value = Camera { $camera }, { $symbol }: known { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px, found { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

# $camera = "d5100"
# $symbol = "c"
# $known_px = 768.0
# $factor = 1.5
# $found_px = 802.0
# $sigma_px = 120.0
held_not_determinable-factor = Camera { $camera }, { $symbol }: known { NUM($known_px, decimals: 0) } px to a factor of { $factor }, found { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

# $camera = "d5100"
# $symbol = "c"
# $value_px = 4800.0
held_not_determinable-scale = Camera { $camera }: { $symbol } held at { NUM($value_px, decimals: 0) } px.

# $camera = "scene_1"
# $model = "rpc"
held_not_determinable-model = Camera { $camera }: all values of model { $model } held.
