# $unit = "foot"
# $factor = 0.3048
# $shift_px = 120.0
# $rms_px = 8.1
# $shift_then_px = 3.0
# $rms_then_px = 0.7
scene_control-height_unit = Control heights seem to be in { $unit }, not in metres.
    .why = Image shift { $shift_px } px and residuals { NUM($rms_px, digits: 2) } px become { $shift_then_px } px and { NUM($rms_then_px, digits: 2) } px.
    .do = Give heights in metres ({ $unit } times { NUM($factor, digits: 10) }).

# $share = 0.4
# $limit = 0.05
# $model = "affine"
# $cause = "exchanged"
# $rms_px = 1.2
scene_control-image_axes = Control points turn or stretch the image by { PERCENT($share) } % with bias { $model } (limit { PERCENT($limit) } %).
    .why = { $cause ->
        [none] Such an error is impossible in an RPC.
       *[other] Such an error is impossible in an RPC. With the correction below, the points fit to { $rms_px } px.
     }
    .do = { $cause ->
        [exchanged] Exchange x_px and y_px
        [x] Count x_px from the left edge
        [y] Count y_px from the upper edge
        [corner] Count x_px and y_px from the upper left corner
       *[none] Check that points and scene belong together, and the order of x_px and y_px
     }.
