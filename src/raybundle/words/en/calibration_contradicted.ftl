# $camera = "d5100"
# $squares = 90.0
# $n = 6
# $limit = 22.5
# $level_percent = 0.1
# $smooth = true
# $ids = ["d5100", "c"]
calibration_contradicted = Camera { $camera }: the photographs contradict its calibration (chi-square { NUM($squares, decimals: 0) }, limit { NUM($limit, decimals: 1) }).
    .why = Focus, zoom or mounting differed{ $smooth ->
        [yes] , or the photographs have smooth errors that their weights do not contain
       *[no] { "" }
     } ({ $n } parameters, { $level_percent } %).
    .do = Calibrate under the conditions of the photographs, or hold the calibration (estimate = []).

# $camera = "d5100"
# $F = 9.2
# $limit = 3.1
# $n = 6
# $level_percent = 0.1
# $effect_px = 2.1
# $sigma_px = 0.3
# $centres = 12.0
# $centres_limit = 6.0
# $ids = ["d5100", "c"]
calibration_contradicted-held = Camera { $camera }: the photographs contradict its held calibration (F { $F }, limit { $limit }).
    .why = It moves image points by up to { NUM($effect_px, digits: 2) } px (sigma { NUM($sigma_px, digits: 2) } px), and projection centres significantly (F { NUM($centres, digits: 3) }, limit { NUM($centres_limit, digits: 3) }; { $n } parameters, { $level_percent } %).
    .do = Check that the calibration belongs to this camera, focus, zoom and format; if so, give its standard deviations or estimate = "auto", or leave it out.

# $camera = "d5100"
# $F = 9.2
# $limit = 3.1
# $n = 6
# $level_percent = 0.1
# $effect_px = 2.1
# $sigma_px = 0.3
# $centres = 2.0
# $centres_limit = 6.0
# $ids = ["d5100", "c"]
calibration_contradicted-harmless = Camera { $camera }: the photographs contradict its held calibration (F { $F }, limit { $limit }).
    .why = It moves image points by up to { NUM($effect_px, digits: 2) } px (sigma { NUM($sigma_px, digits: 2) } px), but projection centres not significantly (F { NUM($centres, digits: 3) }, limit { NUM($centres_limit, digits: 3) }; { $n } parameters, { $level_percent } %), so the calibration may be the better one.
    .do = Compare check points or lengths.

# $symbol = "c"
# $given = 20.5
# $found = 20.4
# $sigma = 0.01
# $unit = "mm"
# $w = 8.1
# $limit = 3.6
# $alone = true
calibration_contradicted-given = Parameter { $symbol }: given { NUM($given, digits: 9) } { $unit }, found { NUM($found, digits: 9) } { $unit } (|w| { NUM($w, decimals: 1) }, limit { NUM($limit, decimals: 1) }{ $alone ->
        [yes] { "" }
        *[no] ; only all parameters together exceed their limit
    }).
    .do = Compare the given value with the calibration certificate.

# $symbol = "c"
# $given = 20.5
# $found = 20.4
# $sigma = 0.01
# $unit = "mm"
# $w = 8.1
# $limit = 3.6
# $alone = true
# $effect_px = 2.1
calibration_contradicted-moved = Parameter { $symbol }: held { NUM($given, digits: 9) } { $unit }, found { NUM($found, digits: 9) } ± { NUM($sigma, digits: 2) } { $unit } ({ NUM($effect_px, digits: 2) } px; |w| { NUM($w, decimals: 1) }, limit { NUM($limit, decimals: 1) }{ $alone ->
        [yes] { "" }
        *[no] ; only all parameters together exceed their limit
    }).
    .do = Compare the held value with the calibration certificate.
