rotation-quaternion = { $kind ->
        [image] Image
        [rig] Rig
       *[frame] Frame
     } { $name } : le quaternion n'a pas de direction.

rotation-not_orthogonal = La matrice de rotation n'est pas orthogonale de déterminant 1.

rotation-too_large = Une rotation dépasse { $limit_rad } rad.
