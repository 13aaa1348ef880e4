# $image = "scene_1"
scene-orientation_given = Image { $image } is a satellite scene; its orientation is in the file of the scene.
    .do = Leave these cells empty.

# $camera = "scene_1"
scene-second_image = Camera { $camera } is a satellite scene and already has an image.
    .do = Use a camera of its own for each scene.

scene-size_unknown = The file of the scene does not contain the image size.
    .do = Give width_px and height_px.

# $scene = "scene.xml"
scene-no_rpc = { $scene } has no RPC.
    .do = Give model = "linescan".

# $scene = "scene.tif"
scene-no_rigorous_model = { $scene } has no supported rigorous model.
    .do = Give model = "rpc".

# $camera = "scene_1"
# $scene = "scene.xml"
scene-file_gone = Camera { $camera }: the file of its scene ({ $scene }) is missing; the block cannot be written.
    .do = Restore the file where it was read.

# $camera = "scene_1"
# $scene = "scene.toml"
scene-companion_gone = Camera { $camera }: { $scene } refers to this file, which is missing.
    .do = Restore the file.

# $unit = "mm"
scene-length_unit = Satellite scenes need length_unit = "m", not "{ $unit }".
