interior-shared = Kamera { $camera }: { $parameter } ist für alle Bilder gleich.
    .do = In block.toml interior = "per_image" setzen oder den Parameter in per_image aufnehmen.

interior-per_image_twice = interior = "per_image" umfasst bereits alle Parameter.
    .do = interior oder per_image löschen.
