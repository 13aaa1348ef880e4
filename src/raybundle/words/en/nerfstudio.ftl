nerfstudio-mixed_models = The block has fisheye and frame cameras; transforms.json represents one camera model.
    .do = Export them separately.

# $model = "'OPENCV'"
nerfstudio-model_contradiction = The flag contradicts camera_model { $model }.
    .do = Correct one of them.

# $angle_deg = 190.0
nerfstudio-field_of_view = A field of view of { $angle_deg }° has no focal length.
    .do = Give an angle between 0° and 180°.

nerfstudio-focal_length_missing = The focal length is missing.
    .do = Give fl_x [px] or camera_angle_x [rad], in the file or in each frame.

# $value = 0.01
# $model = "OPENCV"
nerfstudio-parameter_unused = The value { $value } is given, but { $model } has no such parameter.
    .do = Remove it, or correct camera_model.
