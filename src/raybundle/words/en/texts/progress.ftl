# $stage = "depth_maps"
# $name = "depth maps"
progress-stage = { $name }
