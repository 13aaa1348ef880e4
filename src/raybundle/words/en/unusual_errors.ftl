# $rms_px = 1.9
# $smooth_px = 5.1
# $limit_rms_px = 1.14
# $limit_smooth_px = 3.2
unusual_errors = Unusually large residuals: { NUM($rms_px, digits: 2) } px (limit { $limit_rms_px }), smooth part { NUM($smooth_px, digits: 2) } px (limit { $limit_smooth_px }).
    .why = Likely causes: a wrong camera model (fisheye), several cameras or zooms as one camera, a moving scene, a rolling shutter, or edited photographs.
    .do = Check the residuals of single images, and a length or check points.
