several_cameras = Caméra { $camera } : ses { $photographs } photos proviennent de { $cameras } caméras, focales ou mises au point différentes.

several_cameras-own = { OPTION("own_camera", $pattern) }
