# $kind = "image"
# $name = "'img_07'"
rotation-quaternion = { $kind ->
        [image] Image
        [rig] Rig
       *[frame] Frame
     } { $name }: the quaternion has no direction.
    .do = Export the file again.

rotation-not_orthogonal = The rotation matrix is not orthogonal with determinant 1.
    .do = Export the file again.

# $limit_rad = 1000000.0
rotation-too_large = A rotation exceeds { $limit_rad } rad.
    .do = Export the file again.
