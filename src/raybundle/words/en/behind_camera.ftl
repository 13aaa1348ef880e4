# $n = 2
# $pairs = ["P7 (IMG_1)", "P8 (IMG_1)"]
# $ids = ["P7", "P8"]
behind_camera = { $n } image { $n ->
        [one] point lies
       *[other] points lie
     } behind the camera and { $n ->
        [one] is
       *[other] are
     } left out: { $pairs }.
    .do = Check the point numbers.

# $n = 2
# $limit = 0.1
# $ids = ["IMG_1", "IMG_2"]
behind_camera-photographs = { $n } { $n ->
        [one] photograph has
       *[other] photographs have
     } more than { PERCENT($limit) } % of the tie points behind the camera: { $ids }.
    .why = These photographs may be oriented on the wrong side of the object.
    .do = Compare their positions with where they were taken.

# $n = 2
# $pairs = ["t7 (IMG_1)", "t8 (IMG_1)"]
# $ids = ["t7", "t8"]
behind_camera-matches = { $n } wrong { $n ->
        [one] match
       *[other] matches
     } behind the camera left out: { $pairs }.
    .why = The result does not contain these matches.
    .do = If many matches are wrong, check the photographs for repeated structures.
