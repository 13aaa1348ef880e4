# $n = 24
# $cameras = 1
photographs-found = { $n } { $n ->
        [one] photograph
        *[other] photographs
    }, { $cameras } { $cameras ->
        [one] camera
        *[other] cameras
    }.

# $camera = "1"
# $name = "NIKON D5100"
# $n = 24
# $width_px = 4928
# $height_px = 3264
# $c_px = 5012.3
# $sigma_px = 50.1
# $c_mm = 24.02
# $source = "EXIF"
photographs-camera = Camera { $camera }: { $name }, { $n } { $n ->
        [one] photograph
        *[other] photographs
    } of { $width_px } x { $height_px } px.
    .why = c = { NUM($c_px, decimals: 1) } ± { NUM($sigma_px, decimals: 1) } px = { NUM($c_mm, digits: 4) } mm ({ $source }).

# $n = 20
photographs-more = and { $n } more: { OPTION("json", "True") }.

# $name = "a.jpg"
# $width_px = 160
# $height_px = 120
# $least_px = 300
photographs-small = { $name } has { $width_px } x { $height_px } px, fewer than { $least_px } on a side.
    .why = Hardly anything can be measured in it.
    .do = Check whether it is a preview of the photograph.
