# $c_px = 4600
# $own_px = 5200
camera_start-calibration_differs = Stored calibration: c = { $c_px } px, taken. The photographs: { $own_px } px by

# $ratio = 2.0
# $exif_width = 6000
# $exif_height = 4000
# $width = 3000
# $height = 2000
camera_start-copy = EXIF: { $exif_width } x { $exif_height } px, file: { $width } x { $height } px; taken as a copy, { NUM($ratio, digits: 4) } times smaller.
    .why = A crop of the same shape looks alike in EXIF, and would have a camera constant { NUM($ratio, digits: 4) } times as long in pixels.

# $exif_width = 6000
# $exif_height = 4000
# $width = 3000
# $height = 2000
camera_start-cropped = EXIF: { $exif_width } x { $exif_height } px, file: { $width } x { $height } px: cropped.
    .why = The principal point may be far from the centre.

camera_start-default = default: 1.2 times the longer side

# $value = "'2020;1'"
# $n = 9
camera_start-dewarp_data = XMP's DewarpData { $value } is no date and { $n } numbers; it is not taken.

# $zoom = 1.5
camera_start-digital_zoom = Digital zoom { NUM($zoom, digits: 6) }: the camera constant in pixels grows with it.

camera_start-equivalent = 35 mm equivalent

# $equivalent_mm = 5000.0
# $least_mm = 4.0
# $most_mm = 4000.0
camera_start-equivalent_impossible = No lens has EXIF's 35 mm equivalent of { NUM($equivalent_mm, digits: 6) } mm; it is not taken.
    .why = Lenses have { NUM($least_mm, digits: 6) } to { NUM($most_mm, digits: 6) } mm.

# $plane_mm = 36.78
# $equivalent_mm = 23.6
camera_start-equivalent_taken = Sensor width: focal plane of EXIF { NUM($plane_mm, decimals: 2) } mm, 35 mm equivalent { NUM($equivalent_mm, decimals: 2) } mm; the latter is taken.

camera_start-focal_plane = focal plane resolution

# $plane_mm = 120.0
camera_start-focal_plane_impossible = EXIF's focal plane resolution makes the sensor { $plane_mm } mm wide; it is not taken.

# $distance_m = 0.5
# $share = 0.08
camera_start-focused = Focused at { NUM($distance_m, digits: 6) } m: c may be longer than the focal length by up to { PERCENT($share) } %.

# $entry = "DewarpData"
# $value = "'2'"
camera_start-no_constant = XMP's { $entry } of { $value } is no camera constant of this image; it is not taken.

camera_start-no_metadata = No metadata, the other photographs have some: perhaps from another source.

# $entry = "DewarpData"
# $value = "'x'"
camera_start-no_number = XMP's { $entry } begins with { $value }, no number; it is not taken.

# $focal_mm = 35.0
camera_start-no_sensor_size = Without a sensor size, { NUM($focal_mm, digits: 6) } mm of focal length give no camera constant.

# $share = 0.02
camera_start-not_square = EXIF's focal plane resolutions differ by { PERCENT($share) } %; pixels are taken as square.

# $first = "a.jpg"
# $n = 3
# $stated = false
# $has_serial = true
# $serial = "123"
# $has_lens = false
# $lens = ""
# $others = 20
camera_start-one_camera = { $stated ->
        [yes] Only in
        *[no] Not in
    } { $n ->
        [one] { $first }
        *[other] { $n } photographs ({ $first } ...)
    }: { $has_serial ->
        [yes] serial number { $serial }
        *[no] {""}
    }{ $has_lens ->
        [yes] { $has_serial ->
            [yes] ,{" "}
            *[no] {""}
        }lens { $lens }
        *[no] {""}
    }; one camera with { $others } others.
    .why = All else in their metadata agrees.

# $kind = "cylindrical"
camera_start-panorama = XMP: { $kind } panorama, no central projection; give a stored calibration of another model.

# $camera = "d5100"
camera_start-stored = stored calibration { $camera }

camera_start-table = sensor size table

# $equivalent_mm = 37.06
# $table_mm = 36.0
camera_start-table_doubtful = Sensor width: 35 mm equivalent { NUM($equivalent_mm, decimals: 2) } mm, table { NUM($table_mm, decimals: 2) } mm; the table is taken with a larger sigma.
    .why = The photograph was cropped in the camera, or one of the two is wrong.

# $table_mm = 36.0
# $taken_mm = 23.6
camera_start-table_outvoted = Sensor width: table { NUM($table_mm, decimals: 2) } mm, focal plane and 35 mm equivalent of EXIF { NUM($taken_mm, decimals: 2) } mm; EXIF is taken.

# $plane_mm = 36.78
# $table_mm = 36.0
camera_start-table_taken = Sensor width: EXIF's focal plane resolution { NUM($plane_mm, decimals: 2) } mm, table { NUM($table_mm, decimals: 2) } mm; the table is taken.

camera_start-xmp = XMP calibration

# $c_px = 9000
# $expected_px = 4600
camera_start-xmp_contradicts = XMP gives { $c_px } px, { $expected_px } px are expected; XMP is not taken.

# $low_mm = 18.0
# $high_mm = 55.0
# $focal_mm = 18.0
camera_start-zoom_lens = Zoom lens, { NUM($low_mm, digits: 6) } to { NUM($high_mm, digits: 6) } mm: photographs with { NUM($focal_mm, digits: 6) } mm may differ slightly in focal length.

# $n = 2
# $cameras = ["x-5mm", "x-5mm-2"]
# $photographs = 3
camera_start-cameras = { $n ->
        [one] Camera
        *[other] Cameras
    } { LIST($cameras, most: 20) }: { $photographs } { $photographs ->
        [one] photograph
        *[other] photographs
    }
