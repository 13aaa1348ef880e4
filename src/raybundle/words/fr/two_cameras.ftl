two_cameras = Caméra { $camera } : { $n } et { $others } photographies ont des orientations internes différentes.
