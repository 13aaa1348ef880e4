incomplete = Seules { $oriented } des { $photographs } photographies sont orientées (limite { PERCENT($limit) } %).
