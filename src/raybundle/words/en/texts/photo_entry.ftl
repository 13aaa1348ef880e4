# $source = "EXIF"
photo_entry-altitude_no_fix = { $source } altitude is not used: GPSMeasureMode 2, the receiver had a fix in plan alone.

# $first = "EXIF 112 m"
# $second = "XMP 118 m"
# $apart_m = 6.0
photo_entry-altitudes_contradict = Altitudes contradict each other, none is used: { $first }; { $second }; { $apart_m } m apart.
    .do = Correct one, or give a position list.

# $source = "XMP"
# $first = "EXIF 112 m"
# $second = "XMP 118 m"
# $apart_m = 6.0
photo_entry-altitudes_differ = Altitudes differ, that of { $source } is used: { $first }; { $second }; { $apart_m } m apart.

# $source = "EXIF"
# $longitude = true
photo_entry-angle = { $source } { $longitude ->
        [yes] longitude
        *[no] latitude
    } is not used:

# $value_deg = 190.0
# $limit_deg = 180.0
photo_entry-angle_beyond = { NUM($value_deg, digits: 7) }° is beyond { NUM($limit_deg, digits: 7) }°.

# $source = "EXIF"
# $longitude = true
# $value_deg = -11.0
# $letter = "E"
photo_entry-angle_contradicts = { $source } { $longitude ->
        [yes] longitude
        *[no] latitude
    } is not used: { NUM($value_deg, digits: 7) }° contradicts the reference { $letter }.

# $values = "48.5, 30, 0"
photo_entry-angle_decimals = a part with decimals is followed by a smaller one ({ $values }).

photo_entry-angle_fraction = its degrees or minutes are x/0.

# $n = 4
photo_entry-angle_numbers = { $n } numbers; degrees, minutes and seconds are needed.

# $values = "48, 61, 0"
photo_entry-angle_sixty = minutes or seconds are not within 0 to 60 ({ $values }).

# $dop = 12.0
# $limit = 10.0
photo_entry-dop = GPSDOP { $dop } is above { $limit }: the position is a rough estimate with the usual sigma.

# $directory = "GPS"
# $n = 3
# $of = 12
photo_entry-exif_cut = EXIF: { $n } of { $of } entries of directory { $directory } can be read.

# $directory = "GPS"
# $n = 3
# $of = 12
photo_entry-exif_damaged = EXIF: { $n } of { $of } entries of directory { $directory } are damaged.

photo_entry-exif_no_tiff = EXIF does not begin as a TIFF (II or MM, 42) and is not read.

# $directory = "GPS"
photo_entry-exif_outside = EXIF: directory { $directory } lies outside the data.

# $directory = "GPS"
photo_entry-exif_twice = EXIF: directory { $directory } was read already under another name.

# $source = "XMP"
# $longitude = true
photo_entry-half_missing = { $source } is not used: its { $longitude ->
        [yes] longitude
        *[no] latitude
    } is missing.

# $folder = "photos"
# $n = 12
# $first = "a.dng"
photo_entry-jpeg_taken = { $folder }: { $n } { $n ->
        [one] file has
        *[other] files have
    } a JPEG of the same name, which is taken ({ $first }).

# $source = "EXIF"
# $shift_m = 120.0
# $map_datum = "TOKYO"
# $system = "EPSG:4301"
photo_entry-moved = { $source } position is moved by { $shift_m } m to WGS 84: GPSMapDatum { $map_datum } is { $system }.

# $source = "EXIF"
photo_entry-no_fix = { $source } position 0, 0 is not used: the receiver had no fix.

# $source = "EXIF"
# $status = "V"
photo_entry-no_fix_status = { $source } position is not used: GPSStatus { $status }, the receiver had no fix.

# $source = "EXIF"
# $missing = ["GPSLatitudeRef"]
# $position = "48.1, 11.5"
photo_entry-no_hemisphere = { $source } position without hemisphere is not used, { $missing } missing: { $position }.

# $source = "XMP"
# $latitude_deg = 95.0
# $longitude_deg = 11.0
photo_entry-no_place = { $source } is not used, no place on the earth: { NUM($latitude_deg, digits: 9) }, { NUM($longitude_deg, digits: 9) }.

# $source = "EXIF"
# $map_datum = "X"
photo_entry-no_transformation = { $source } position is not used: no transformation from GPSMapDatum { $map_datum } to WGS 84.

# $orientation = 9
photo_entry-orientation = EXIF orientation { $orientation } is not one of 1 to 8; taken as 1.

# $folder = "photos"
# $n = 3
# $suffixes = [".txt"]
photo_entry-other_files = { $folder }: { $n } other { $n ->
        [one] file is
        *[other] files are
    } not read ({ $suffixes }).

# $source = "XMP"
# $first = "EXIF 112 m"
# $second = "XMP 118 m"
# $apart_m = 6.0
photo_entry-position_contradicts = { $source } position is not used, it contradicts the others: { $first }; { $second }; { $apart_m } m apart.

# $step_m = 11.0
# $position = "EXIF 48.1, 11.5"
photo_entry-position_rounded = Position rounded to { $step_m } m: { $position }.

# $first = "EXIF 112 m"
# $second = "XMP 118 m"
# $apart_m = 6.0
photo_entry-positions_contradict = Positions contradict each other, none is used: { $first }; { $second }; { $apart_m } m apart.
    .do = Correct one, or give a position list.

# $source = "XMP"
# $first = "EXIF 112 m"
# $second = "XMP 118 m"
# $apart_m = 6.0
photo_entry-positions_differ = Positions differ, that of { $source } is used: { $first }; { $second }; { $apart_m } m apart.

# $folder = "photos"
# $n = 2
# $names = ["b"]
photo_entry-sub_folders = { $folder }: { $n } { $n ->
        [one] sub-folder is
        *[other] sub-folders are
    } not read ({ $names }).
    .do = Give sub-folders as inputs of their own.

# $detail = "no element found"
photo_entry-xmp_damaged = XMP is damaged from here on and not read further: { $detail }.

# $bytes = 9000000
# $most = 1000000
photo_entry-xmp_long = XMP of { $bytes } bytes is longer than { $most } and is not read.

# $entry = "drone-dji:RelativeAltitude"
# $value = "'x'"
photo_entry-xmp_no_number = XMP { $entry }: { $value } is no number and is not used.

# $bands = 4
# $band = 1
# $colour = false
# $numbers = "float32"
# $scaled = true
photo_entry-bands = { $colour ->
     [yes] Luminance of red, green, blue (of { $bands } bands)
     *[no] Band { $band } of { $bands }
    } is matched ({ $numbers }{ $scaled ->
     [yes] ; 0.1 to 99.9 % as 0 to 65535, if not whole within these
     *[no] { "" }
    }).
