# $n = 12
# $scale = 0.4
# $limit = 0.1
gps_too_near = The positions of { $n } photographs are too close together and are not used.
    .why = They determine the scale to { PERCENT($scale) } % (limit { PERCENT($limit) } %).
    .do = Give control or a scale bar.
