# $n = 2
# $orientations = [6]
# $ids = ["a.jpg", "b.jpg"]
mask_orientation = The position of { $n } { $n ->
        [one] mask
       *[other] masks
    } is ambiguous (EXIF orientation { $orientations }): { LIST($ids, most: 3) }.
    .why = Masks are applied to the pixels as stored, as by COLMAP and Metashape; masks drawn over the upright picture hide the wrong part.
    .do = Rotate such masks back, or save them with EXIF orientation 1.
