# $name = "1"
# $image = "scan.tif"
fiducial-one_coordinate = Fiducial mark { $name } in image { $image } has one coordinate only.
    .do = Give x and y, or neither to remove it.

# $name = "1"
# $image = "scan.tif"
fiducial-not_measured = Fiducial mark { $name } is not measured in image { $image }.
    .do = Give x and y to measure it.

# $image = "scan.tif"
# $n = 2
# $least = 3
fiducial-too_few = Scan { $image }: { $n } fiducial marks are measured; { $least } are needed.
    .why = The others are then found automatically.
    .do = Measure { $least } that are not on one line.

# $model = "projective"
fiducial-unknown_model = model = { $model } is unknown.
    .do = Write similarity or affine.

# $name = "9"
# $known = ["1", "2"]
fiducial-not_calibrated = Fiducial mark { $name } has no calibrated position.
    .do = Use one of { LIST($known, most: 8) }.

fiducial-no_film = These photographs are not scans of film: no fiducial mark has a calibrated position.
    .do = Start the project with a certificate: { OPTION("film", "CERTIFICATE") }.

fiducial-no_scans = The photographs are not scans of film, so they have no fiducial marks.
    .do = If the photographs are scans of film, start the project with a certificate: { OPTION("film", "CERTIFICATE") }.
