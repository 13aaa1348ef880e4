# $sigma_m = 10.0
# $ids = ["scene_1"]
scene_prior-rpc = The RPC of { $ids } has no accuracy (ERR_BIAS); { $sigma_m } m on the ground are assumed.
    .why = Without control the result is only as good as this assumption.
    .do = Give control points: { OPTION("control") }.

# $sigma_rad = 0.0001
# $ids = ["scene_1"]
scene_prior-orbit = { $ids } has no RPC; the attitude of the orbit file is assumed good to { $sigma_rad } rad.
    .why = Without control the result is only as good as this assumption.
    .do = Give control points: { OPTION("control") }.

# $sigma_m = 5.0
# $sigma_s = 0.0005
# $ids = ["scene_1"]
scene_prior-radar = Range and clock of { $ids } are assumed good to { $sigma_m } m and { $sigma_s } s.
    .why = Without control the result is only as good as this assumption.
    .do = Give control points: { OPTION("control") }.
