# $byte = 1200
binary-ends_in_record = The file ends within a record (byte { $byte }).
    .do = Get the complete file.

# $kind = "camera"
# $number = 3
# $byte = 1200
binary-number_not_finite = { $kind ->
        [camera] Camera
        [image] Image
        [point] Point
        [rig] Rig
       *[frame] Frame
     } { $number }: a number is not finite or too large (byte { $byte }).
    .do = Export the file again.

# $kind = "images"
# $n = 1000000
# $most = 12
# $byte = 8
binary-count_too_large = The file announces { $n } { $kind ->
        [cameras] cameras
        [images] images
        [image_points] image points
        [points] points
        [track_elements] track elements
        [rigs] rigs
       *[frames] frames
     }; it has space for { $most } (byte { $byte }).
    .do = Get the complete file.

# $most = 4096
# $byte = 1200
binary-name_too_long = A name is longer than { $most } bytes (byte { $byte }).
    .do = Check that the file is not damaged.

# $byte = 1200
binary-name_not_utf8 = A name is not UTF-8 (byte { $byte }).
    .do = Check that the file is not damaged.

# $n = 48
# $byte = 1200
binary-bytes_left = { $n } bytes follow the last record (byte { $byte }).
    .why = The file is probably of another version of the format.
    .do = Export it again.
