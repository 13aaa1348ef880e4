# $images = ["img_01", "img_02"]
station-velocity_unknown = The time offset dt needs the velocity of each image; it is unknown for { $images }.
    .do = Give velocities, or times of images before or after on the flight line, or hold dt at 0.
