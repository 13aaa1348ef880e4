selection-nothing_beyond = Keine Bildbeobachtung überschreitet { $limit } in { $quantity }.
    .do = Eine andere Grenze angeben.

selection-unknown_quantity = Die Größe { $quantity } ist unbekannt.
    .do = Eine von { LIST($known, most: 9) } verwenden.
