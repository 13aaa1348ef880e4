# $n = 2
# $camera = "d5100"
# $turned_deg = 180
# $ids = ["IMG_1", "IMG_2"]
stored_turned = { $n } photograph { $n ->
        [one] file is
       *[other] files are
     } stored turned by { $turned_deg }°: { $ids }.
    .why = Image points of the result are in the pixels of camera { $camera }, not in those of the file.
    .do = Measure marks in the file; do not copy them from observations.csv.

# $n = 2
# $camera = "d5100"
# $width_px = 600
# $height_px = 400
# $ids = ["IMG_1", "IMG_2"]
stored_turned-size = { $n } photograph { $n ->
        [one] file has
       *[other] files have
     } another size ({ $width_px } × { $height_px } px) than camera { $camera }: { $ids }.
    .why = Image points of the result are in the pixels of the camera, not in those of the file.
    .do = Measure marks in the file; do not copy them from observations.csv.
