# $name = "d5100"
# $symbol = "c"
# $share = 0.35
# $limit = 0.2
# $ids = ["d5100", "c"]
camera_constant_unknown = Camera { $name } is not calibrated: { $symbol } is known only to { PERCENT($share) } % (limit { PERCENT($limit) } %).
    .why = The shape of the object is as uncertain.
    .do = Give a calibration, or take photographs that converge and show depth.
