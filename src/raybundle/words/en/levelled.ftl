# $angle_deg = 5.0
# $sigma_m = 1.2
# $ids = ["A", "B"]
levelled = The heights of the control are unknown: the block is levelled by its viewing direction, to about { NUM($angle_deg, decimals: 0) }°.
    .why = Heights are relative and may be tilted by this angle; they are observed with { $sigma_m } m.
    .do = Give the heights of three control points.
