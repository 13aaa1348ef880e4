# $camera = "d5100"
# $parameter = "'c_mm'"
interior-shared = Camera { $camera }: { $parameter } is the same for all images.
    .do = Set interior = "per_image" in block.toml, or add the parameter to per_image.

interior-per_image_twice = interior = "per_image" already includes all parameters.
    .do = Delete interior or per_image.
