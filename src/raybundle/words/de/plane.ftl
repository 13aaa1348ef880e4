plane-points_in_line = Ebene { $name }: Ihre Punkte liegen auf einer Geraden.
    .why = Die Ebene kann sich um diese Gerade drehen.
    .do = Einen Punkt neben der Geraden ergänzen.

plane-axes_not_orthogonal = right, up und normal sind keine rechtshändigen orthogonalen Einheitsvektoren (Abweichung { $deviation }, Grenze { $limit }).
    .do = Die Datei neu schreiben.

plane-place_unknown = Die Lage der Ebene im Raum ist unbekannt; right, up und normal fehlen.
    .do = Die Aufnahme erneut entzerren.

plane-other_unit = Die Einheit der Ebene ist { $plane }, die des Blocks { $block }.
    .do = Die Ebene eines Bildes dieses Blocks angeben.
