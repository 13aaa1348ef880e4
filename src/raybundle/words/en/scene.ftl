# $image = "scene_1"
scene-orientation_given = Image { $image } is a satellite scene; its orientation is in the file of the scene.
    .do = Leave these cells empty.

# $camera = "scene_1"
scene-second_image = Camera { $camera } is a satellite scene and already has an image.
    .do = Use a camera of its own for each scene.

scene-size_unknown = The file of the scene does not contain the image size.
    .do = Give width_px and height_px.

# $scene = "scene.xml"
scene-no_rpc = { $scene } has no RPC.
    .do = Give model = "linescan".

# $scene = "scene.tif"
scene-no_rigorous_model = { $scene } has no supported rigorous model.
    .do = Give model = "rpc".

# $camera = "scene_1"
# $scene = "scene.xml"
scene-file_gone = Camera { $camera }: the file of its scene ({ $scene }) is missing; the block cannot be written.
    .do = Restore the file where it was read.

# $camera = "scene_1"
# $scene = "scene.toml"
scene-companion_gone = Camera { $camera }: { $scene } refers to this file, which is missing.
    .do = Restore the file.

# $unit = "mm"
scene-length_unit = Satellite scenes need length_unit = "m", not "{ $unit }".

# $name = "'../flight.csv'"
scene-file_elsewhere = { $name } is not the name of a file in the folder of this file.
    .do = Copy the file into this folder, and give its name only.

# $other = "detector"
scene-keys_exclusive = This key and { $other } exclude each other.
    .do = Delete one of the two.

scene-crs_superfluous = The table has longitude and latitude, which need no coordinate system.
    .do = Delete this key.

scene-crs_missing = The coordinate system of the positions X, Y, Z is missing.
    .do = Write it into the file, for example crs = "EPSG:25832".

# $formats = ["DIMAP 1 XML of SPOT 5: orbit", "GeoTIFF with RPC (tag 50844)"]
scene-format_unknown = The format of the satellite scene is unknown.
    .why = Known formats: { LIST($formats, most: 30) }.
    .do = Give the metadata or the RPC of the scene.

# $value = 120.5
scene-pixel_count = { NUM($value, digits: 6) } is not a possible number of pixels.
    .do = Give a whole number above 0.

# $n = 3
# $least = 4
scene-position_count = Positions of the orbit: { $n }; at least { $least } are needed.
    .do = Get a complete file.

# $n = 3
# $least = 4
scene-attitude_count = Attitudes: { $n }; at least { $least } are needed.
    .do = Get a complete file.

# $distance_m = 7000.0
# $least_m = 6500000.0
# $most_m = 50000000.0
scene-not_an_orbit = A position is { NUM($distance_m, digits: 6) } m from the earth's centre (limits { $least_m } to { $most_m } m).
    .do = Give the positions in metres.

# $element = "Instrument_Look_Angles"
scene-no_look_angles = The viewing directions ({ $element }) are missing.
    .why = Viewing directions in another form are not supported.
    .do = Get a complete file, or use the RPC of the product.

scene-no_picture = The scene has no picture.
    .do = Give the raster of the scene.

# $n = 11000
# $columns = 12000
scene-look_angle_count = Viewing directions: { $n }; the image has { $columns } columns.
    .do = Get a complete file.

# $number = 17.0
scene-detector_order = Detector { NUM($number, digits: 6) } is out of order: the table has a gap.
    .do = Get a complete file.

scene-same_time = Two positions have the same time.
    .do = Delete one of them.

# $scene = "DIM_PNEO.XML"
# $meets = true
# $rms_px = 812.5
# $limit_px = 12.5
# $stated = true
scene-models_contradict = { $scene }: rigorous model and RPC differ by { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px rms
     *[no] more than the image
    } (limit { $limit_px } px).
    .why = The limit is { $stated ->
     [yes] the stated error of the RPC
     *[no] aberration and refraction together
    }; one of the two models is wrong.
    .do = Get the file again, or use the RPC alone (model rpc).

# $meets = true
# $rms_px = 812.5
# $limit_px = 12.5
# $stated = true
scene-rpc_preferred = Only the RPC is used: the rigorous model differs by { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px rms
     *[no] more than the image
    } (limit { $limit_px } px).
    .why = The limit is { $stated ->
     [yes] the stated error of the RPC
     *[no] aberration and refraction together
    }.
    .do = Get the file again if the rigorous model is needed.

scene-no_geometry = The file contains neither an RPC nor a usable rigorous model.
    .do = Get a complete file of the scene.

scene-rpc_range_adapted = The RPC was rewritten for the range of this image, a part of a scene.
    .why = Its offsets were outside the image; the polynomials are the same.

# $n = 2
# $band = "PAN"
scene-one_band = The scene has { $n } bands; the viewing directions of band { $band } are used.
