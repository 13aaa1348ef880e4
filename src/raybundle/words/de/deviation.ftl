deviation-parameter_not_free = Bild { $image } in deviations.csv: { $parameter } wird nicht je Bild geschätzt.
    .do = Den Parameter bei der Kamera in per_image und estimate aufnehmen oder interior = "per_image" setzen.
