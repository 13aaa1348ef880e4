memory-no_room = Kein Platz für ein Feld von { $size_mb } MB ({ $detail }).
    .do = Speicherplatz freigeben oder mehr Arbeitsspeicher erlauben.
