reduced_features = Les éléments viennent de copies réduites à { $size_px } px : { $oriented } des { $photographs } photographies sont orientées.
