# $n = 60
# $of = 1800
# $seconds = 60.0
# $width_px = 1920
# $height_px = 1080
video-frames = Frames: { $n } of { $of } chosen ({ NUM($seconds, decimals: 1) } s, { $width_px } x { $height_px } px).

video-no_motion = The view hardly moves: frames without a base give no object coordinates.

# $n = 3
video-same_frames = { $n } { $n ->
        [one] frame shows the same as the one before and is left out.
        *[other] frames show the same as the one before and are left out.
    }

# $n = 3
# $frames = [12, 40, 88]
# $share = 0.5
video-blurred = { $n } chosen { $n ->
        [one] frame is
        *[other] frames are
    } less than { PERCENT($share) } % as sharp as the typical frame: { $frames }.

# $n = 18
# $wanted = 20
video-fewer_frames = { $n } frames instead of { $wanted }: the others lie too close together.
