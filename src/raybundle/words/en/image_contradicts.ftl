# $image = "IMG_7"
# $camera = "d5100"
# $ratio = 8.2
# $limit = 3.0
# $p = 1e-09
# $limit_p = 0.0001
# $ids = ["IMG_7"]
image_contradicts = Image { $image } contradicts the others: residuals { $ratio } times theirs (camera { $camera }; limit { $limit }).
    .why = The whole image is affected (by chance with p { NUM($p, digits: 1) }, limit { NUM($limit_p, digits: 1) }): another camera, focus or zoom; mirrored, turned or cropped; or exchanged points.
    .do = Give it a camera of its own, correct its image points, or leave it out.

# $image = "IMG_7"
# $camera = "d5100"
# $ratio = 8.2
# $limit = 3.0
# $rms_px = 12.0
# $limit_px = 4.0
# $ids = ["IMG_7"]
image_contradicts-interior = Image { $image } contradicts the others: it has an interior orientation of its own ({ NUM($rms_px, digits: 2) } px rms).
    .why = Its residuals show this { $ratio } times as clearly as other images of camera { $camera } (limits { $limit } and { NUM($limit_px, digits: 2) } px); it may be cropped, enlarged, stretched or zoomed.
    .do = Give it a camera of its own, or leave it out.

# $images = 1
# $limit = 0.5
# $median = 0.02
# $ids = ["IMG_7"]
image_contradicts-rejected = { $images } { $images ->
        [one] image has
       *[other] images have
     } more than { PERCENT($limit) } % of the image points rejected (median { PERCENT($median) } %): { $ids }.
    .why = The whole image contradicts the others: another camera, focus or zoom; mirrored or cropped; or exchanged names.
    .do = Give it a camera of its own, correct its image points, or leave it out.

# $image = "IMG_7"
# $sigma0 = 1.1
# $sigma0_with = 12.0
# $ids = ["IMG_7"]
image_contradicts-without_it = Image { $image } contradicts the others: sigma0 is { $sigma0 } without it, { $sigma0_with } with it.
    .why = It may be from another camera, or its image points have wrong names.
    .do = Correct its image points, give it a camera of its own, or leave it out.

# $n = 2
# $names = ["IMG_1", "IMG_2"]
# $ids = ["IMG_1", "IMG_2"]
image_contradicts-origin = { $n } { $n ->
     [one] image has
     *[other] images have
    } image points to the left of and above the format: { $names }.
    .why = Their origin seems to be the middle of the image.
    .do = Give pixels from the upper left corner, x to the right and y down.

# $images = 2
# $names = ["IMG_1", "IMG_2"]
# $ratio = 1.5
# $sigma0 = 1.1
# $sigma0_given = 12.0
# $ids = ["IMG_1", "IMG_2"]
image_contradicts-camera_constant = { $images } { $images ->
     [one] image has
     *[other] images have
    } another camera constant, { NUM($ratio, digits: 5) } times that of the others: { $names }.
    .why = sigma0 is { $sigma0 } with a camera constant for each image, { $sigma0_given } with one for all: another camera, zoom or focus.
    .do = Give them a camera of their own.

# $n = 1
# $names = ["IMG_7.jpg"]
# $share = 0.24
# $median = 0.99
# $limit = 0.6
# $ids = ["IMG_7"]
image_contradicts-matches = { $n } { $n ->
     [one] photograph contradicts
     *[other] photographs contradict
    } the others: few of the matches fit the orientation: { LIST($names, most: 5) }.
    .why = At best { PERCENT($share) } % fit (others { PERCENT($median) } %, limit { PERCENT($limit) } %): another camera or zoom; stretched or cropped; or a wrong place.
    .do = Leave { $n ->
     [one] it
     *[other] them
    } out, or give { $n ->
     [one] it
     *[other] them
    } a camera of { $n ->
     [one] its
     *[other] their
    } own: { OPTION("own_camera", "PATTERN") }.
