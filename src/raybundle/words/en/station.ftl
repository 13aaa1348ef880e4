# $images = ["img_01", "img_02"]
station-velocity_unknown = The time offset dt needs the velocity of each image; it is unknown for { $images }.
    .do = Give velocities, or times of images before or after on the flight line, or hold dt at 0.

# $image = "IMG_1"
# $camera = "left"
station-shared_with_parameters = Image { $image } shares its station and has parameters of its own (camera { $camera }).
    .do = Remove the shared station, or per_image of the camera.

# $images = ["L1", "R1"]
station-orientations_differ = Images { $images } share a station but have different exterior orientations.
    .do = Give each image the orientation of the rig, and the offsets as parameters of the mounted cameras.

# $images = ["L1", "R1"]
station-partly_held = Images { $images } share a station and only some of them are held.
    .do = Hold all of them, or none.
