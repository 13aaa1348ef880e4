

# $kind = "building"
# $distance_m = 2.0
# $near_m = 3.5
# $far_m = 20.0
plan-not_sharp = { $kind ->
        [sheet] The sheet that fills the format
        [facade] The facade for stereo pairs
        [turntable] The object on its turntable
       *[building] The building
     } at { $distance_m } m is out of focus (sharp: { $near_m } to { $far_m } m).
    .do = Focus at this distance ({ OPTION("focus") }), or stop down ({ OPTION("f_number") }).

plan-no_flat_sheet = A calibration list needs a flat sheet or a board.
    .do = Give sheet:WIDTH,HEIGHT, or a board.

plan-no_footprint = The object has no footprint: seen from above it is a line or a point.
    .do = Give an object with an area on the ground.

# $distance_m = 12.3
# $clearance_m = 10.0
# $reach_m = 8.0
# $needed_m = 12.3
plan-ring_too_far = The ring of stations is { $distance_m } m from the walls; { $reach_m } m are available.
    .why = Stations must not be nearer than { $clearance_m } m ({ OPTION("clearance") }).
    .do = Give { $needed_m } m ({ OPTION("around") }), or a smaller clearance.

# $height_m = 20.0
# $distance_m = 25.0
# $reach_m = 15.0
# $c_mm = 14.0
plan-height_not_shown = The height of { $height_m } m needs a distance of { $distance_m } m in portrait format; { $reach_m } m are available.
    .do = Use a lens with c = { NUM($c_mm, digits: 2) } mm ({ OPTION("c") }), a higher station ({ OPTION("eye") }), or more distance ({ OPTION("around") }).

# $side = 2
# $distance_m = 3.5
plan-no_stereo_overlap = Side { $side }: the two photographs of a pair from { $distance_m } m do not overlap.
    .do = Use a lens with a wider angle.

plan-stations_missing = The stations of the photographs are missing; targets are placed for them.
    .do = Give { OPTION("stations", "plan/stations.csv") }, as raybundle plan network writes it.

# $n = 2
# $rays = 3
# $stations = 12
plan-too_few_target_places = { $n } places of the object are visible from { $rays } of the { $stations } stations; targets need 4.
    .do = Plan more photographs.

# $size_mm = 120.0
# $across_px = 8.0
# $space_mm = 90.0
plan-targets_too_large = Targets need { NUM($size_mm, decimals: 0) } mm each; the object has { NUM($space_mm, decimals: 0) } mm for each.
    .why = Their dots have { $across_px } px in the farthest photograph.
    .do = Use fewer targets ({ OPTION("count") }), nearer stations, or smaller dots ({ OPTION("across") }).

# $n = 6
# $step_deg = 60.0
plan-turn_too_large = { $n } steps of a turn are { NUM($step_deg, decimals: 0) }° each; neighbouring photographs do not overlap enough.
    .do = Use at least 8 steps.

# $length_m = 5.0
# $longest_m = 3.2
plan-no_place_for_bars = No two points of the object with a clear line between them are { $length_m } m apart, the length of a scale bar.
    .why = The farthest two are { $longest_m } m apart.
    .do = Use shorter scale bars, or more points.

# $n = 4000
# $low = [0.0, 0.0, 0.0]
# $high = [5.0, 5.0, 2.0]
# $clearance_m = 3.0
plan-no_station_allowed = None of { $n } tested positions is allowed for a station.
    .why = Object, clearance of { $clearance_m } m and forbidden boxes fill the space from ({ $low }) to ({ $high }) m.
    .do = Enlarge the space, or reduce the clearance.

# $n = 400
# $least = 6
# $near_m = 3.0
# $incidence_deg = 60.0
plan-object_not_seen = None of { $n } allowed positions sees { $least } points of the object.
    .why = The depth of field begins at { $near_m } m; rays may be { $incidence_deg }° off the normal.
    .do = Allow more distance, or a larger angle of incidence.

# $station = 5
plan-station_not_allowed = Station { $station } is outside the limits, too near to the object, or in a forbidden box.
    .do = Move or delete it.

# $names = ["P1", "P2"]
# $n = 2
plan-points_not_adjusted = { $n ->
        [0] No point is given
       *[other] Points are not in the adjustment: { $names }
     }.
    .do = Give points that the adjustment estimates.

# $camera = "d5100"
plan-camera_fixed = Camera { $camera }: no parameter is estimated, so none can be improved.
    .do = Estimate its parameters in the adjustment.

# $n = 2
# $least = 3
plan-too_few_control = { $n } control points do not define a datum; { $least } are needed.
    .do = Plan at least { $least } control points.

# $n = 3
plan-control_not_sufficient = { $n } control points do not determine the datum of this network.
    .do = Plan more control points.

# $pattern = "'orbit'"
plan-mission_pattern = The precision of a mission of pattern { $pattern } cannot be predicted.
    .why = The parts of the object in its photographs are unknown.
    .do = Use raybundle plan network with the shape of the object.

# $aim = "reliability"
plan-aim_no_sigma = The aim { $aim } is not a standard deviation.
    .do = Give the number of stations instead of the wanted value.

plan-no_goal = The plan has neither a wanted standard deviation nor a number of stations.
    .do = Give one of the two.

# $n = 12
# $share = 0.4
plan-points_rarely_found = Points of this kind are detected so rarely that the network of { $n } stations often fails.
    .why = It fails in { PERCENT($share) } % of the simulated detections.
    .do = Plan more stations or points, or use targets.

# $n = 400
# $least = 6
plan-nothing_seen_again = None of { $n } possible stations sees { $least } points of the block.
    .do = Allow more positions ({ OPTION("step") }, { OPTION("around") }) or a larger angle ({ OPTION("incidence") }).

# $n = 3
# $wanted = 10
plan-too_few_candidates = { $n } candidate stations see enough points; { $wanted } photographs are requested.
    .do = Request fewer photographs: { OPTION("photographs") }.

plan-no_object_points = The adjustment has no object point that a photograph could show.
    .do = Adjust a block with object points.

# $camera = "d5200"
# $known = ["d5100"]
plan-unknown_camera = The block has no camera { $camera }.
    .do = Use one of { LIST($known, most: 10) }.

# $camera = "scene_1"
# $model = "linescan"
plan-no_frame_camera = Camera { $camera } ({ $model }) is not a frame camera of single stations.
    .why = Proposals need one station for each photograph and one interior orientation for all; scenes, rolling shutters and rigs have neither.
    .do = Choose another camera.

# $camera = "d5100"
plan-camera_not_used = Camera { $camera } has no photograph in the adjustment.
    .do = Choose another camera.

# $name = "hall.ply"
# $off = 1.2
# $limit = 0.3
plan-object_elsewhere = Object { $name }: half of the points are more than { $off } off its surface (limit { $limit }).
    .do = Give the object in the frame and length unit of the block.

# $block = "facade"
plan-not_oriented = Block { $block } has photographs without orientation.
    .do = Orient or adjust it first.

# $block = "facade"
# $image = "left.jpg"
plan-photograph_not_oriented = Photograph { $image } of block { $block } has no orientation.
    .do = Orient or adjust the block first.

# $camera = "d5100"
plan-no_common_interior = Camera { $camera } has no interior orientation common to its photographs.
    .do = Choose a camera with common interior orientation.

# $n = 400
plan-no_station_within = None of { $n } stations is within the limits.
    .do = Widen { OPTION("step") }, { OPTION("around") }, { OPTION("heights") }, { OPTION("clearance") } or { OPTION("forbid") }.

plan-one_place = Photographs from one place cannot be compared with the list.
    .do = Check that they belong to this list.

# $n = 3
# $total = 20
# $off = 0.31
# $limit = 0.2
plan-other_list = The stations of these photographs agree with the list in at most { $n } of { $total } places.
    .why = They are off by { NUM($off, decimals: 2) } of the object distance (limit { NUM($limit, decimals: 2) }).
    .do = Check that the photographs belong to this list.

# $n = 3
# $total = 200
# $least = 3
# $given = false
plan-too_few_visible = { $n } of { $total } points of the object are visible from { $least } { $given ->
        [yes] of the given stations
       *[no] possible stations
     }.
    .do = Widen the space for stations, or allow larger angles of incidence.

# $most = 400
# $least = 3
plan-no_network_sees_all = No network of up to { $most } stations sees every point { $least } times.
    .do = Widen the space for stations, reduce the number of rays, or exclude the hidden parts.

# $wanted_mm = 0.01
# $n = 40
# $reached_mm = 0.05
# $near_m = 2.0
# $sigma_px = 0.3
# $sigma_mm = 0.1
plan-beyond_reach = A standard deviation of { $wanted_mm } mm is not possible: { $n } stations reach { $reached_mm } mm.
    .why = At the nearest distance of { $near_m } m, { $sigma_px } px are { NUM($sigma_mm, digits: 2) } mm on the object.
    .do = Go nearer, or use a longer lens or targets with a smaller standard deviation.

# $station = 3
# $n = 2
# $total = 200
# $least = 6
# $stations = 4
# $all_stations = 12
# $given = true
plan-station_sees_too_few = Station { $station } sees { $n } of { $total } points of the object; its orientation needs { $least }.
    .why = This concerns { $stations } of { $all_stations } stations.
    .do = { $given ->
        [yes] Check that stations and object have the same frame
       *[no] Use more points, more space for stations, or a wider lens
     }.

# $stations = 12
# $n = 30
# $total = 200
# $least = 3
plan-too_few_rays = With { $stations } stations, { $n } of { $total } points of the object have fewer than { $least } rays.
    .do = Plan more stations, more space for them, or a lens with a wider angle.

# $stations = 4
# $free = true
plan-not_determined = A network of { $stations } stations does not determine all unknowns.
    .do = { $free ->
        [yes] Plan more points or stations, or fix the camera parameters
       *[no] Plan more points or stations
     }.

# $n = 23
# $planned = 24
plan-list_count = The list has { $n } photographs, the plan { $planned }.
    .do = Create the list again.

plan-list_missing = The printed list is missing.
    .do = Create the list again.

plan-list_edges = The edges of the object are missing, or have not two ends each.
    .do = Create the list again.

plan-station_at_itself = A station has itself as the point at which it looks.
    .do = Correct its at_X, at_Y and at_Z.

# $near_m = 3.5
# $far_m = 2.0
plan-never_sharp = Photographs are sharp from { $near_m } m on; stations are at most { $far_m } m away.
    .do = Choose a larger { OPTION("f_number") }, another { OPTION("focus") } or a larger { OPTION("around") }.

plan-points_and_aim = { OPTION("points") } belongs to { OPTION("aim", "worst") }.
    .do = Leave one of the two out.

# $n = 420
plan-no_improvement = None of { $n } candidate stations reduces a standard deviation.
    .why = The geometry of the photographs is not the limit.
    .do = Add control, scale bars or more precise image points, or extend { OPTION("step") } or { OPTION("around") }.

plan-focus_without_scale = { OPTION("focus") } needs the scale of the block, which is not determined.
    .do = Leave it out.

# $kind = "castle"
# $known = ["building", "facade"]
plan-unknown_list = There is no list of the kind { $kind }.
    .do = Use one of { LIST($known, most: 20) }.

# $point = "P7"
plan-point_missing = Point { $point } of the block of the plan is missing.
    .do = Create the plan again.

# $total = 24000
# $most = 10000
# $lines = 120
# $photographs = 200
# $area = true
# $width_m = 2000.0
# $length_m = 3000.0
# $base_m = 15.0
# $spacing_m = 17.0
plan-flight_too_large = The flight has { $total } photographs; forecasts are possible for up to { $most }.
    .why = { $lines } lines of { $photographs } photographs{ $area ->
        [yes] { " " }cover { NUM($width_m, digits: 6) } x { NUM($length_m, digits: 6) } m (base { $base_m } m, lines { $spacing_m } m apart)
       *[no] { "" } are given
     }.
    .do = Forecast a part of it with the same base and spacing: { $area ->
        [yes] { OPTION("area") }, { OPTION("gsd") }, { OPTION("overlap") }
       *[no] { OPTION("lines") }, { OPTION("photographs_per_line") }
     }.

plan-list_alike_turned = The list looks the same after a turn: photographs are assigned by their order.
    .why = If they were taken in another order, what is missing may be on another side.

# $n = 30
# $of = 40
plan-list_most_beside = { $n } of { $of } photographs are not on the list.
    .do = Check that the photographs belong to this list.

# $n = 30
# $of = 40
plan-list_most_missing = { $n } of { $of } photographs of the list are missing.
    .why = Few photographs agree with many places by chance.
    .do = Check that the photographs belong to this list.

# $wanted = 5
# $n = 3
plan-nothing_lowers = { $n } of { $wanted } photographs are proposed: no further one within reach lowers the figure.

# $share = 0.03
plan-hardly_lowers = Photographs within reach lower the figure by { PERCENT($share) } % only.
    .do = Add control, scale bars or more precise image points, or allow other stations ({ OPTION("step") }, { OPTION("around") }).

# $n = 4
# $of = 60
# $sides = ["+Z", "-Y"]
# $rays = 4
plan-points_out_of_sight = { $n } of { $of } points are visible from fewer than { $rays } possible stations ({ $sides }).
    .why = No precision is predicted for them.
    .do = Allow more stations ({ OPTION("heights") }, { OPTION("clearance") }, { OPTION("incidence") }, { OPTION("around") }).

# $share = 0.1
plan-object_between_points = { PERCENT($share) } % of the object, between the points, is seen by fewer than two photographs.
    .do = Plan with more { OPTION("object_points") }.

# $share = 0.04
# $worst = 0.8
# $unit = "mm"
plan-points_seldom_found = { PERCENT($share) } % of the points are expected in fewer than two photographs.
    .why = Figures are medians over random draws; in one of ten surveys the worst point reaches { NUM($worst, digits: 2) } { $unit }.

# $share = 0.1
plan-network_falls_apart = In { PERCENT($share) } % of random draws the network falls apart.
    .do = Take more photographs.

# $overlap = 0.4
plan-little_overlap = The forward overlap is { PERCENT($overlap) } %.
    .why = Below 50 %, points between the photographs of a line are seen once.
    .do = Plan at least 60 % forward overlap.

# $overlap = -0.1
plan-gaps_between_lines = The flight lines leave gaps (side overlap { PERCENT($overlap) } %).
    .do = Plan lines nearer to each other.

plan-flown_apart = Flown exactly as planned, the photographs do not hold together.
    .why = Neighbours have too narrow a strip in common.
    .do = Plan more { OPTION("overlap") }.

# $parameters = ["c", "az"]
plan-flown_lost = Flown exactly as planned, parameters are not determinable: { $parameters }.

plan-flown_calibrated = No change of the flight that was tried determines them.
    .do = Hold the camera as calibrated before the flight.

# $low = 2.5
# $high = 5.7
plan-free_camera = Measured sigma of natural points was { $low } to { $high } times the plan's.
    .why = Four sets, with the camera calibrated with the object.
    .do = Hold a calibrated camera ({ OPTION("hold_camera") }), or plan with that margin.

# $seen_deg = 84.1
# $planned_deg = 73.7
plan-other_camera = The field of view is { NUM($seen_deg, decimals: 0) } degrees; { NUM($planned_deg, decimals: 0) } degrees were planned.
    .why = The lens, its zoom or the part of the format differs from the plan.
    .do = Take the photographs with the planned camera, or plan with this one.

# $parameters = ["c", "x0"]
# $lost = false
# $level = ["c", "x0"]
# $remedy = "headings alternate"
# $figures = ["Z 1.5 m to 20 mm"]
# $hold = "camera"
plan-flight_undetermined = { $lost ->
        [yes] This flight does not determine { $parameters }.
        *[no] Only the unevenness of the flight determines { $parameters }.
    }
    .why = { $lost ->
            [yes] Not determined if exactly level at one height: { $level }.
            *[no] A flight exactly level at one height does not determine them.
        }
    .do = { $remedy ->
            [none] { $hold ->
                [camera] No change of the flight helps: hold the camera as calibrated ({ OPTION("hold_camera", "True") }).
                [lever_arm] No change of the flight helps: measure the lever arm and hold it.
                *[both] No change helps: hold the camera ({ OPTION("hold_camera", "True") }) and the measured lever arm.
            }
            *[other] Change the plan: { $remedy }. Sigma: { $figures }.
        }

# $low = 1.5
# $high = 3.0