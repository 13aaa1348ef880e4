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
    .do = Give model = "linescan", of radar "range_doppler".

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
    .do = Set length_unit = "m" in block.toml, and give all lengths and coordinates in metres.

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

# $model = "rigorous"
# $choice = true
scene-model_missing = The scene has no { $model ->
        [rpc] RPC
       *[rigorous] rigorous model
     }.
    .do = { $choice ->
        [yes] Use { OPTION("model", "auto") }
       *[no] Give a scene with a rigorous model, from which an RPC is computed
     }.

scene-none_here = There is no scene here: no picture with an RPC and no file of an RPC.
    .do = Check the path.

# $n = 12
scene-none_corrected = None of { $n } { $n ->
        [one] scene
       *[other] scenes
     } can be corrected:
    .do = Correct scenes or control as described below.

# $scene = "scene_1.tif"
scene-not_corrected = Scene { $scene } is not corrected:

# $name = "scene_1"
scene-name_twice = Two scenes have the name { $name }.
    .do = Rename one of them.

scene-rpc_missing = The scene has no RPC.
    .do = Compute one: raybundle rpc fit.

scene-height_range_missing = The range of heights is unknown: the scene has no RPC.
    .do = Give { OPTION("heights", "LOW", "HIGH") }.

scene-original_rpc = The file of the original RPC already exists; it is never overwritten.
    .do = Move it, or write a new file: { OPTION("out", "FILE") }.

scene-no_geotiff = This is not a GeoTIFF; an RPC can be written into a GeoTIFF only.
    .do = Write a new file: { OPTION("out", "FILE") }.

scene-rpc_of_no_picture = { OPTION("rpc") } belongs to a picture; this is none.
    .do = Leave it out.

# $kind = "DataArray"
scene-object_without_rpc = Neither the object of type { $kind } nor its file has an RPC.
    .do = Give { OPTION("rpc", "FILE") }.

scene-rpc_not_in_picture = There is no RPC in this picture (tag 50844) or beside it.
    .why = Files beside it are NAME_RPC.TXT, NAME.RPB, NAME.rpc, NAME.XML and NAME.geom.
    .do = Give the file with the RPC: { OPTION("rpc", "FILE") }.

scene-outside_map = The scene shows no part of the area of the map.
    .do = Choose another { OPTION("extent") }.

# $width_px = 60000
# $height_px = 60000
# $bands = 4
scene-map_too_large = The map has { $width_px } x { $height_px } px of { $bands } bands, too many for memory.
    .do = Write it to a file: { OPTION("out", "FILE.tif") }.

# $value = -9999.0
# $type = "uint8"
scene-no_data_type = { OPTION("nodata", $value) } is not a value of { $type }, the type of the pixels.
    .do = Give a value of this type.

scene-single = There is one satellite scene and no photograph; two images of the same ground are needed.
    .do = Give a second scene, or photographs of the same ground.

# $n = 2
# $pairs = 1
scene-no_tie_points = { $n } { $n ->
        [one] usable scene
       *[other] usable scenes
    } without tie points and without marked control.
    .why = Pairs with common ground: { $pairs }.
    .do = Check that the scenes show the same place in a similar season with their own RPC, or mark control points: { OPTION("control") }.

# $scene = "scene_1"
# $longitude_deg = 11.52
# $latitude_deg = 48.15
scene-middle = Scene { $scene }: middle at longitude { NUM($longitude_deg, decimals: 3) }°, latitude { NUM($latitude_deg, decimals: 3) }°.

scene-control_far_away = Control marked in this scene is far outside it.
    .do = Check the coordinate system and the numbers of the control points.

# $n = 4
# $model = "scene_1.RPB"
# $dx_px = 120.0
# $dy_px = -8.0
# $limit_x_px = 40.0
# $limit_y_px = 40.0
scene-control_shifted = { $n } marked control points are off by { NUM($dx_px, decimals: 0) }, { NUM($dy_px, decimals: 0) } px (limit { NUM($limit_x_px, decimals: 0) }, { NUM($limit_y_px, decimals: 0) } px).
    .why = The limit is that of the stated accuracy of { $model }.
    .do = Check that { $model } belongs to this image; check coordinate system, heights and numbers of the control points.

# $n = 4
# $model = "scene_1.RPB"
# $dx_px = 12.0
# $dy_px = -8.0
# $spread_x_px = 14.0
# $spread_y_px = 2.0
# $limit_x_px = 5.0
# $limit_y_px = 5.0
scene-control_scattered = { $n } marked control points scatter by { NUM($spread_x_px, decimals: 1) }, { NUM($spread_y_px, decimals: 1) } px (limit { NUM($limit_x_px, decimals: 1) }, { NUM($limit_y_px, decimals: 1) } px).
    .why = No common shift fits them (median { NUM($dx_px, decimals: 0) }, { NUM($dy_px, decimals: 0) } px).
    .do = Check that { $model } belongs to this image; check coordinate system, heights and numbers of the control points.

# $suffix = "ntf"
# $source = "a.ntf"
# $target = "a.tif"
scene-pixels_not_supported = Pixels of { $suffix } files are not supported.
    .do = Convert it to TIFF (gdal_translate { $source } { $target }), with its RPC beside it.

# $width_px = 4000
# $height_px = 3000
# $model = "scene_1.RPB"
# $model_width_px = 8000
# $model_height_px = 6000
scene-other_size = The image has { $width_px } x { $height_px } px, { $model } is for { $model_width_px } x { $model_height_px } px.
    .do = Give the file of this image.

scene-all_zero = The image has no grey value above 0.
    .do = Give an image of the ground.

scene-no_texture = The image has no texture.
    .do = Check whether it is an image of the ground.

# $longitude_deg = 11.5
# $latitude_deg = 48.1
# $system = "EPSG:2056"
scene-outside_system = The scene at longitude { NUM($longitude_deg, decimals: 4) }°, latitude { NUM($latitude_deg, decimals: 4) }° is outside { $system }.
    .do = Give another coordinate system: { OPTION("crs") }.

# $longitude_deg = 11.5
# $latitude_deg = 48.1
scene-not_covered = The raster does not cover the scene, at longitude { NUM($longitude_deg, decimals: 5) }°, latitude { NUM($latitude_deg, decimals: 5) }°.
    .do = Give the height raster of this area.

# $x = 534700.0
# $y = 5338160.0
# $longitude_deg = 11.5
# $latitude_deg = 48.1
scene-control_without_system = The control has no coordinate system, and { NUM($x, digits: 8) }, { NUM($y, digits: 8) } are no degrees near the scenes.
    .why = The scenes are at longitude { NUM($longitude_deg, decimals: 4) }°, latitude { NUM($latitude_deg, decimals: 4) }°.
    .do = Give the coordinate system: { OPTION("crs", "EPSG:...") }.

scene-name_taken = Another scene has the same name.
    .do = Rename one of the two.

# $n = 40
# $shift_px = 120.0
# $limit_px = 40.0
# $prior_px = 8.0
# $times = 4.0
scene-pair_shifted = { $n } common points agree on a shift of { NUM($shift_px, decimals: 0) } px (limit { NUM($limit_px, decimals: 0) } px).
    .why = The limit is { $times } times the stated accuracy of { NUM($prior_px, decimals: 1) } px.
    .do = Check that each image has its own RPC or XML beside it, and whether it was cut, scaled or turned.

# $n = 40
# $spread_px = 14.0
# $limit_px = 4.0
scene-pair_scattered = { $n } common points scatter by { NUM($spread_px, decimals: 0) } px (limit { $limit_px } px); no common shift fits them.
    .do = Check that each image has its own RPC or XML beside it, and whether it was cut, scaled or turned.

# $n = 40
# $height_m = 9000.0
# $low_m = 0.0
# $high_m = 1000.0
scene-pair_height = The rays of { $n } common points meet at { NUM($height_m, decimals: 0) } m; the RPCs are valid for { NUM($low_m, decimals: 0) } to { NUM($high_m, decimals: 0) } m.
    .do = Check that each image has its own RPC or XML beside it, and whether it was cut, scaled or turned.

# $model = "scene_1.RPB"
# $other = "scene_2"
scene-contradicts_other = The geometry of this scene ({ $model }) contradicts scene { $other }, which agrees with other scenes.

# $first = "scene_1"
# $second = "scene_2"
scene-pair_contradicts = Scenes { $first } and { $second } contradict each other; which one is wrong is ambiguous.
    .do = Add a third scene of the same place, or give control points: { OPTION("control") }.

# $name = "scene.tif"
# $point = "P1"
# $n = 12
scene-no_place = { $name }, point { $point }: none of the { $n } points has a place.
    .do = Check the coordinates of the points.

# $n = 12
# $height_m = 350.0
scene-no_ground_found = No ground points were found for { $n } image points of the radar scene, at height { $height_m } m.
    .do = Check the heights.

# $x_px = 12.5
# $y_px = 100.0
# $range_m = 500000.0
# $height_m = 350.0
scene-range_too_short = The range { $range_m } m of image point { $x_px }, { $y_px } does not reach height { $height_m } m.
    .do = Check the height and the column.

# $names = ["annotation/s1a-iw1.xml", "annotation/s1a-iw2.xml"]
scene-several_in_folder = The folder holds several scenes: { $names }.
    .do = Give one of these files.

scene-radar_delays = Delays of the atmosphere and tides of the earth are left to range offset and clock.

# $n = 10
# $noise_m = 0.126
# $noise_m_s = 0.012
scene-orbit_noise = { $n } noisy state vectors ({ NUM($noise_m, digits: 2) } m, { NUM($noise_m_s, digits: 2) } m/s) replaced by a fitted polynomial.
    .why = Interpolation amplifies their noise.

# $n = 9
scene-bursts = { $n } bursts: lines between them are taken twice, and no RPC fits the whole image.

# $n = 9
# $lines = 1501
# $rows = 13508
scene-burst_lines = { $n } bursts of { $lines } lines do not make { $rows } lines.
    .do = Get the file again.

scene-no_ground_range = The table of ground ranges is empty.
    .do = Get the file again.

scene-ground_range_origins = The origin of ground ranges changes along the image, which is not supported.

# $n = 12
# $side = "right"
scene-wrong_side = The radar scene looks to the { $side ->
    [right] right
   *[left] left
  } of its track, but all { $n } points lie on the other side.
    .why = Ranges and times are the same on both sides.
    .do = Correct the look direction of the scene, or the coordinates.

# $kind = "GEC"
scene-map_product = The image of this product ({ $kind }) is a map, not in the geometry of the radar.
    .do = Get the product in slant range or ground range, or use this one as an orthophoto.

# $n = 36
scene-burst_images = The { $n } bursts of this product are images of their own, which overlap.
    .do = Get the product in ground range.

# $n = 2
scene-values_differ = This element occurs { $n } times, with different values.
    .do = Get the product of one beam or polarisation.

# $seconds = -3.5
scene-line_order = The times of the first and the last line ({ $seconds } s apart) contradict this element.
    .do = Get the file again.

# $reached_m = 952000.0
# $stated_m = 948000.0
scene-range_extent = The columns end at { NUM($reached_m, digits: 8) } m, the file states { NUM($stated_m, digits: 8) } m.
    .do = Get the file again.

# $n = 120
# $meets = true
# $rms_px = 3.5
# $limit_px = 1.0
scene-tie_points = The { $n } tie points of the file differ from its orbit and ranges by { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px rms
     *[no] more than the image
    } (limit { $limit_px } px).
    .do = Check the scene with control points, or get the file again.

# $path = "sourceAttributes/orbitAndAttitude"
scene-rpc_only = Only the RPC is used: the file has no { $path }.

# $range_m = 2.85
# $seconds = 0.0001
scene-delays_applied = Delays that the product states are applied: { $range_m } m of range, { $seconds } s of time.

scene-delays_missing = The file states no delays (ANNOTATION/GEOREF.xml is missing); range offset and clock take them.

# $kind = "'PFA RGAZIM'"
scene-image_formation = An image formed by { $kind } is not read; only range and zero Doppler (RMA, INCA) is.
    .do = Get the product in slant range with zero Doppler (RGZERO), or one in ground range.

# $seconds = 0.00002
scene-times_curved = The times of the columns deviate from a straight line by { $seconds } s, which is not supported.
    .do = Use the RPC of the scene.

scene-no_sicd = No data extension of this NITF holds the metadata of a SICD.
    .do = Get the file again.

# $what = "landsat"
scene-is_map = { $what ->
     [landsat] A Landsat product
     [sentinel2] A Sentinel-2 product
     [orthoimage] An orthoimage (DIMAP)
    *[raster] A georeferenced raster
    } is a map already; it has no geometry of a sensor to adjust.
    .do = Use it as a map: as a reference for control, as an underlay. To orient a scene, give its product in sensor geometry, with RPC or orbit.

# $n = 210
scene-no_orbit = The picture has { $n } points on the ground, but neither orbit nor RPC.
    .why = So come GRD rasters of radars apart from their annotation.
    .do = Give the annotation XML or the product folder (SAFE).

# $what = "aster"
scene-product_not_read = { $what ->
     [aster] ASTER level 1A (HDF)
     [sentinel2] Sentinel-2 level 1B
     [ceos] Volume directories and image files of CEOS
     [saocom] SAOCOM products
     [kompsat5] Auxiliary XML of KOMPSAT-5
     [cphd] Phase histories (CPHD)
    *[hdf] HDF files
    } are not read.
    .do = { $what ->
     [aster] Give an RPC of it, as aster2asp of the Ames Stereo Pipeline writes
     [sentinel2] Use the level 1C product, which is a map
     [ceos] Give the leader file beside it (LEA_01.001)
     [saocom] Convert it to SICD
     [kompsat5] Give the HDF5 product
     [cphd] Give the image of it (SICD)
    *[hdf] Give an RPC of the scene, or convert it to SICD
    }.

# $name = "GEOLOCATION GRID ADS"
scene-record_missing = The file has no { $name }.
    .do = Get the complete file.

# $kind = "ASA_IM__0P"
scene-raw_product = { $kind } is a raw product (level 0): it holds signals, no image.
    .do = Get the product in slant range or ground range (level 1).

# $seconds = 0.001
# $n_px = 1.7
scene-times_rounded = Times of lines are rounded by up to { $seconds } s ({ $n_px } lines), which the clock takes.

# $steps = 0.4
# $limit = 0.001
scene-not_uniform = The values of this table leave an equal spacing by { $steps } steps (limit { $limit }).
    .do = Get the file again.

# $name = "frequencyA"
# $others = "frequencyB"
scene-image_used = The image { $name } is used; the file also holds { $others }.
