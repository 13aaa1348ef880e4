video-frames = Einzelbilder: { $n } von { $of } gewählt ({ NUM($seconds, decimals: 1) } s, { $width_px } x { $height_px } px).
