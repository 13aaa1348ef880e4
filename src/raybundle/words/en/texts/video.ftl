# $n = 60
# $of = 1800
# $seconds = 60.0
# $width_px = 1920
# $height_px = 1080
video-frames = Frames: { $n } of { $of } chosen ({ NUM($seconds, decimals: 1) } s, { $width_px } x { $height_px } px).
