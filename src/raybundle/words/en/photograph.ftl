photograph-empty = The file is empty.
    .do = Copy it again from the camera.

# $begin = "'GIF89a......'"
photograph-kind_unknown = This is not a supported image (it begins with { $begin }).
    .do = Convert it to JPEG, PNG or TIFF.

photograph-video = This is a video.
    .do = Extract its sharp frames with raybundle frames.

photograph-anymap = This is a portable anymap (PGM, PPM) without metadata.
    .do = Save it as PNG or TIFF, without loss.

# $detail = "cannot identify image file"
photograph-header_unreadable = The header of the image cannot be read ({ $detail }).
    .do = Copy the file again.

# $bands = 4
# $bits = [32]
# $format = "floating"
# $planar = false
photograph-tiff_pixels = A TIFF with bands: { $bands }, { $bits } bits, { $format ->
        [whole] whole numbers
        [signed] signed whole numbers
        [floating] floating point
       *[other] another number format
     }{ $planar ->
        [yes] , band after band
       *[no] { "" }
     }, is not supported.
    .do = Write 8-bit colour or one band of 8 or 16 bits (gdal_translate -ot Byte -scale, -b BAND).

# $width_px = 0
# $height_px = 4000
photograph-no_size = The header of the image gives { $width_px } x { $height_px } px.
    .do = Copy the file again.

# $width_px = 60000
# $height_px = 40000
# $megapixels = 2400.0
# $limit_megapixels = 1000.0
photograph-too_large = The image has { $width_px } x { $height_px } px, { $megapixels } megapixels (limit { $limit_megapixels }).
    .do = Reduce it, or split it into parts.

# $extra = "heic"
photograph-package_missing = This format needs an additional package.
    .do = Run: pip install 'raybundle[{ $extra }]'

# $bits = 32
photograph-bits = The image has { $bits } bits per channel; 8 and 16 are supported.
    .do = Convert it.

# $detail = "image file is truncated"
# $disk = false
photograph-pixels_unreadable = The pixels cannot be decoded ({ $detail }).
    .do = { $disk ->
        [yes] Check the disk or the memory card
       *[no] Copy the file again
     }.

photograph-pixels_16_bit = The 16-bit pixels cannot be decoded.
    .do = Save the file as 8-bit TIFF or PNG.

# $original = "img_07.jpg"
photograph-copy = The content is identical to { $original }.
    .do = Delete one of the two.

# $width_px = 60
# $height_px = 40
photograph-too_small = The image has { $width_px } x { $height_px } px, too few for measurements.
    .do = Use the photograph in full size.

# $width_px = 30000
# $height_px = 20000
# $size_bytes = 1200
photograph-no_content = { $width_px } x { $height_px } px in { $size_bytes } bytes: this is not a photograph.
    .do = Remove the file.

# $width_px = 320
# $height_px = 240
# $typical_megapixels = 24.0
photograph-thumbnail = The image is a thumbnail of { $width_px } x { $height_px } px; the others have { $typical_megapixels } megapixels.

# $width_px = 3000
# $height_px = 2000
# $header_width_px = 6000
# $header_height_px = 4000
photograph-size_changed = The image has { $width_px } x { $height_px } px; its header gives { $header_width_px } x { $header_height_px }.
    .why = The file was probably replaced during the run.
    .do = Run again.

photograph-changed = The file was replaced by another one during the run.
    .do = Run again.

photograph-none_oriented = No photograph is oriented yet.
    .do = Measure the points listed below.

# $image = "scan.tif"
# $n = 2
# $least = 3
photograph-lacks_fiducials = Scan { $image }: { $n } fiducial marks are measured; { $least } are needed.
    .do = Measure more fiducial marks.

# $image = "scan.tif"
# $detail = "marks 1 and 2 contradict each other"
photograph-film_contradicts = Scan { $image }: its fiducial marks do not fit ({ $detail }).
    .do = Measure them again.

# $image = "left.jpg"
# $n = 3
# $least = 6
photograph-lacks_marks = Photograph { $image }: { $n ->
        [0] no point is marked in it
       *[other] none of its { $n } points is marked in another photograph
     }.
    .do = Mark { $least } points in both.

# $image = "left.jpg"
# $other = "right.jpg"
# $n = 3
# $least = 6
photograph-lacks_common = Photographs { $image } and { $other } have { $n } common points; { $least } are needed.
    .do = Mark more points in both.

# $image = "left.jpg"
# $n = 3
# $least = 4
photograph-lacks_known = Photograph { $image } shows { $n } points with coordinates; { $least } are needed.
    .do = Mark more points with coordinates.

# $image = "left.jpg"
# $other = "right.jpg"
# $n = 8
photograph-lacks_base = Photographs { $image } and { $other }: the rays to their { $n } points are parallel.
    .why = They were taken from one place.
    .do = Mark points in a photograph from another place.

# $image = "left.jpg"
# $n = 8
photograph-lacks_fit = Photograph { $image }: no orientation fits its { $n } points.
    .do = Check their names and places, and mark more.

# $width_px = 3000
# $height_px = 2000
# $camera_width_px = 6000
# $camera_height_px = 4000
photograph-size_of_calibration = The photograph has { $width_px } x { $height_px } px, the calibration { $camera_width_px } x { $camera_height_px } px.
    .do = Give a photograph of the calibrated set.

photograph-folder_unknown = The folder of the photographs is unknown.
    .do = Give { OPTION("photos", "FOLDER") }.

# $n = 1
# $unreadable = 3
# $names = ["a.jpg", "b.jpg", "c.jpg"]
photograph-too_few = Photographs in this folder: { $n }; two are needed.
    .why = { $unreadable ->
        [0] { "" }
       *[other] Files that cannot be read: { $unreadable } ({ LIST($names, most: 3) }).
     }
    .do = Check the path.

photograph-none = There is no photograph here.
    .do = Give photographs, or folders of photographs.

# $width_px = 6000
# $height_px = 4000
# $block_width_px = 4000
# $block_height_px = 6000
photograph-other_size = The file has { $width_px } x { $height_px } px, its image in the block { $block_width_px } x { $block_height_px } px.
    .why = This is another photograph.
    .do = Give the photograph that was used for the block.

# $names = ["img_99.jpg"]
photograph-not_in_result = Not in the result: { $names }.
    .do = Give photographs of the result.

photograph-no_longer_readable = Photographs became unreadable during the run.
    .do = Check the disk or network drive, and run again.

# $n = 1
# $least = 2
photograph-too_few_usable = { $n } usable { $n ->
        [one] photograph
       *[other] photographs
    }; at least { $least } { $least ->
        [one] is
       *[other] are
    } needed.
    .do = Give a folder of photographs, or their files.

photograph-in_no_folder = The file is in none of the folders of the photographs.

photograph-none_readable = No photograph of the block can be read.
    .do = Check the folder of the photographs.

# $bits = 32
photograph-map_raster = A floating-point raster ({ $bits } bits) in a map holds heights or results, not a photograph.
    .do = If it is a photograph, remove its place in the map (gdal_edit.py -unsetgt).

# $n = 3
# $detail = "503, message='Service Unavailable'"
photograph-not_fetched = It could not be fetched in { $n } attempts ({ $detail }).
    .do = Run the same command again when the service answers.

# $known = ["https", "s3"]
photograph-unknown_scheme = Photographs are not read by this protocol.
    .do = Give a URL of one of these: { $known }.
