# $kind = "dict"
# $detail = "'dict' object has no attribute 'long_off'"
rpc-not_of_rasterio = An object of type { $kind } is not an RPC of rasterio ({ $detail }).
    .do = Give dataset.rpcs.

# $name = "coefficients"
# $shape = [4, 19]
# $needed = [4, 20]
rpc-wrong_shape = RPC: { $name } has shape ({ $shape }), or values that are not finite.
    .do = Give finite numbers of shape ({ $needed }).

# $name = "image_scale"
# $values = [1000.0, 0.0]
rpc-not_positive = RPC: { $name } is { $values }.
    .do = Give values above 0.

# $latitude_deg = 120.0
# $longitude_deg = 48.0
rpc-centre_out_of_range = RPC: latitude { $latitude_deg }°, longitude { $longitude_deg }° of the centre are not valid.
    .why = The limits are 90° and 360°.
    .do = Check whether the two are exchanged.

# $axis = "line"
rpc-zero_denominator = RPC: the { $axis ->
        [line] line
       *[sample] sample
     } denominator is zero at the centre of the scene.
    .do = Get the file again; it is damaged.

# $image_line = 120.25
# $sample = 3300.5
# $height_m = 90000.0
# $others = 3
# $n = 10
# $low_m = 0.0
# $high_m = 500.0
rpc-no_ground_point = Image point line { NUM($image_line, decimals: 2) }, sample { NUM($sample, decimals: 2) } has no ground point at height { $height_m } m.
    .why = { $others ->
        [0] The RPC is valid for heights from { $low_m } to { $high_m } m.
       *[other] The RPC is valid for heights from { $low_m } to { $high_m } m. { $others } other points of { $n } have no ground point either.
     }
    .do = Give a height within this range.

# $n = 4
# $total = 10
# $point = "P1"
# $longitude_deg = 48.2
# $latitude_deg = 16.4
# $ratio = 900.0
# $centre_longitude_deg = 16.37
# $centre_latitude_deg = 48.21
# $limit = 50.0
# $exchanged = true
rpc-points_far_away = { $n } of { $total } points are far outside the scene; point { $point } is { NUM($ratio, digits: 4) } times its range away.
    .why = { $point } is at { NUM($longitude_deg, decimals: 6) }°, { NUM($latitude_deg, decimals: 6) }°, the centre at { NUM($centre_longitude_deg, decimals: 6) }°, { NUM($centre_latitude_deg, decimals: 6) }° (limit { $limit } ranges).
    .do = { $exchanged ->
        [yes] Exchange longitude and latitude, in the points or in the RPC
       *[no] Check that points and scene belong together, and the order and units of the columns
     }.

# $axis = "line"
# $ratio = 0.01
# $limit = 0.05
# $longitude_deg = 16.371
# $latitude_deg = 48.208
# $height_m = 9000.0
# $low_m = 0.0
# $high_m = 500.0
rpc-small_denominator = RPC: the { $axis ->
        [line] line
       *[sample] sample
     } denominator is { NUM($ratio, digits: 2) } of its value at the centre (limit { $limit }).
    .why = The point is at { NUM($longitude_deg, decimals: 6) }°, { NUM($latitude_deg, decimals: 6) }°, { NUM($height_m, decimals: 1) } m; the RPC is valid from { $low_m } to { $high_m } m.
    .do = Check that the point is in the scene, or get the RPC again.

# $shape = [4, 2]
rpc-point_shape = The points have shape ({ $shape }).
    .do = Give an array of shape (n, 3): longitude, latitude, height.

# $low_m = 200.0
# $high_m = 200.0
rpc-height_range = The range of heights is { $low_m } to { $high_m } m.
    .do = Give a range of at least 1 m.

rpc-no_fit = No RPC without a zero in a denominator fits this model.
    .why = The range of heights or the image is too large for one RPC.
    .do = Give a smaller range of heights, or a part of the image.

# $misfit_px = 2.5
# $limit_px = 0.1
# $latitude_deg = 89.2
# $polar = true
rpc-inaccurate_fit = The best RPC deviates from this model by { $misfit_px } px (limit { $limit_px } px).
    .why = { $polar ->
        [yes] The scene reaches latitude { NUM($latitude_deg, decimals: 3) }°, near a pole, where longitudes are ambiguous.
       *[no] The image or the range of heights is too large, or the model is not smooth.
     }
    .do = Use the rigorous model, or a part of the image.

# $scene = "scene.tif"
rpc-scene_localisation = Scene { $scene }: an image point has no ground point.
    .why = The RPC is not valid at this image point or height.
    .do = Check the image coordinates and the height, or get the RPC again.

# $kind = "shift"
# $n = 8
# $x_px = 0.31
# $y_px = 0.42
rpc-corrected = RPC { $kind ->
        [none] not corrected
        *[other] corrected by { $kind }
    }: residuals { NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px (rms, { $n } { $n ->
        [one] control point
        *[other] control points
    }).

# $n = 3
# $x_px = 0.3
# $y_px = 0.4
# $rms_m = 0.6
rpc-check_points = { $n } { $n ->
        [one] check point
        *[other] check points
    }: { NUM($rms_m, digits: 2) } m on the ground ({ NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px rms).

# $bias_m = 0.2
# $rand_known = true
# $rand_m = 0.3
rpc-ground_errors = Ground accuracy (68 %, per axis): ERR_BIAS { NUM($bias_m, digits: 2) } m, ERR_RAND { $rand_known ->
        [yes] { NUM($rand_m, digits: 2) } m
        *[no] unknown
    }.

# $n = 1
# $of = 8
# $names = ["P3"]
# $largest_px = 4.2
rpc-points_contradict = { $n } of { $of } control points contradict the others: { $names } (up to { NUM($largest_px, digits: 2) } px).
    .why = They are not used.
    .do = Check their coordinates, heights and image measurements.

# $n = 2
# $names = ["P3", "P5"]
rpc-points_outside = { $n } { $n ->
        [one] control point is
        *[other] control points are
    } outside the picture or the heights of the RPC: { $names }.
    .why = The RPC is not valid there.
    .do = Check their heights and image coordinates.

# $ratio = 5.1
rpc-shift_large = The shift is { NUM($ratio, digits: 2) } times the bias that the vendor states.
    .why = Control points or RPC may be of another scene or datum.
    .do = Check the coordinate system and the vertical datum of the control points.

# $ratio = 2.3
# $sigma_px = 0.4
rpc-residuals_large = Residuals are { NUM($ratio, digits: 2) } times the stated sigma of { $sigma_px } px.
    .why = Standard deviations are enlarged by this factor.
    .do = Check the stated sigma and the measurements.

# $n = 1
rpc-no_redundancy = { $n } control { $n ->
        [one] point leaves
        *[other] points leave
    } no redundancy.
    .why = A wrong point is not detected.
    .do = Measure one more control point.

# $height_m = 0.1
# $by_points = true
# $east = 0.3
# $north = -0.1
rpc-error_sources = 1 m of wrong height moves a ground point { NUM($east, digits: 2) } m east, { NUM($north, digits: 2) } m north.
    .why = Heights of control contribute { NUM($height_m, digits: 2) } m to ERR_BIAS; ERR_RAND is { $by_points ->
            [yes] the scatter of the points
            *[no] stated by the vendor
        }.

# $largest_px = 0.02
rpc-refitted = Refitted RPC: at most { NUM($largest_px, digits: 2) } px from the corrected one.

# $width_px = 20000
# $height_px = 12000
# $first_column = 0
# $last_column = 5000
# $first_row = 0
# $last_row = 4000
rpc-other_image = The RPC does not belong to this image of { $width_px } x { $height_px } px.
    .why = The RPC covers columns { $first_column } to { $last_column } and rows { $first_row } to { $last_row }.
    .do = Give the RPC of this image; for a reduced or cut image, adapt its offsets and scales.

rpc-projection_not_finite = RPC: its projection is not finite inside the scene.
    .do = Get the file again; it is damaged.

# $names = ["LINE_OFF"]
rpc-keys_missing = The RPC is incomplete; missing: { LIST($names, most: 10) }.
    .do = Get the complete file.

# $name = "LINE_NUM_COEFF"
# $n = 19
rpc-coefficient_count = The RPC is incomplete: { $name } has { $n } of 20 coefficients.
    .do = Get the complete file, in the form RPC00B.

rpc-metadata_below = Metadata of domain RPC is in a lower element, not in the root.
    .do = Give the file of the raster that has the RPC.

# $n = 2
# $names = ["scene_1", "scene_2"]
rpc-not_one = The file contains { $n } RPCs{ $n ->
     [0] { "" }
     *[other] { " " }({ $names })
    }; exactly one is needed.
    .do = Give a file of one image.

# $value = "120.5"
# $other = "121.5"
# $other_line = 3
rpc-two_values = This key is { $value } here and { $other } in line { $other_line }.
    .do = Delete one of the two.

# $unit = "'feet'"
# $needed = "meters"
rpc-unit = The unit is { $unit }; the RPC needs { $needed }.
    .do = Convert the RPC.

rpc-no_tag = The TIFF file contains no RPC (tag 50844).
    .do = Give the file with the RPC (_RPC.TXT, .RPB, .XML).

# $n = 90
rpc-tag_count = The RPC tag has { $n } numbers; 92 are needed.
    .do = Get the file again; it is damaged.

rpc-not_finite = RPC: a number is not finite.
    .do = Get the file again; it is damaged.

rpc-geotiff_needs_picture = A GeoTIFF with RPC needs the picture of the scene, which is missing.
    .do = Give the raster as scene, or write NAME_RPC.TXT, NAME.RPB or NAME.geom.

# $name = "scene_RPC.TXT"
rpc-file_precedes_tag = { $name } is in the same folder; GDAL would read its RPC instead of the tag.
    .do = Move it elsewhere, or choose another name.

# $ending = ".xyz"
rpc-name_ending = { $ending ->
     [blank] The name has no ending
     *[other] The ending { $ending } belongs to no format of RPC
    }.
    .do = Choose NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif for the picture with its RPC.

rpc-tag_differs = The tag written by GDAL differs from the RPC; no file is written.
    .do = Write NAME_RPC.TXT, NAME.RPB or NAME.geom.

rpc-terms_reordered = The terms of the RPC00A were converted to the order of RPC00B.

# $specification = "RPC00X"
rpc-specification_assumed = { $specification ->
     [none] The specification of the RPC is missing
     *[other] The specification of the RPC is { $specification }
    }; RPC00B is assumed.

# $ratio = 900.0
# $limit = 50.0
rpc-point_far_away = A point is { NUM($ratio, digits: 4) } times the range of the RPC from the centre of the scene (limit { $limit }).
    .do = Check the order and units of the coordinates.

# $scene = "a.xml"
# $points = ["7"]
rpc-control_set_aside = Scene { $scene }: points contradict the others and are not used: { $points }.
    .do = Check their coordinates and image points.

# $scene = "a.xml"
rpc-scene_left_out = Scene { $scene } is not corrected.

# $n = 2
# $points = ["7", "8"]
rpc-points_beyond = Points outside the range for which the RPC was made: { $points }.
    .why = There an RPC may be wrong by many pixels.

# $n = 2
# $points = ["7", "8"]
# $which = "image"
rpc-points_lost = Points without { $which ->
    [ground] ground
    *[image] image
 } coordinates: { $points }.
    .why = Their cells are empty; the column note has the reason.

# $n = 9
rpc-bursts = No RPC fits an image of { $n } bursts: lines between them are taken twice.
    .do = Use the scene itself (model = "range_doppler"), or get the product in ground range.
