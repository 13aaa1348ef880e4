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
