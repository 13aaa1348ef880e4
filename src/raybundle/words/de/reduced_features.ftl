reduced_features = Die Merkmale sind aus Kopien von { $size_px } px: Damit sind { $oriented } von { $photographs } Aufnahmen orientiert.
    .why = Merkmale in voller Größe orientieren { $whole }: Die Aufnahmen sind unscharf, verrauscht oder stark komprimiert.
