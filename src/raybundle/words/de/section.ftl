section-outside = Linie { $number } liegt außerhalb des Höhenrasters.
    .why = Das Raster reicht in X von { NUM($left, digits: 10) } bis { NUM($right, digits: 10) }, in Y von { NUM($bottom, digits: 10) } bis { NUM($top, digits: 10) }.
    .do = { OPTION("line") } korrigieren.

section-too_many_places = Linie { $number } hätte { $n } Stellen; höchstens { $most } sind möglich.
    .do = { OPTION("step") } größer wählen.

section-beyond_end = { $name } ist { NUM($length, digits: 6) } lang; { OPTION("between") } hat eine Stelle bei { NUM($at, digits: 6) }.
    .do = Zwei Stellen entlang der Linie angeben.

section-same_place = { OPTION("between") } hat die Stelle { NUM($at, digits: 6) } zweimal.
    .do = Zwei verschiedene Stellen angeben.

section-no_height = { $name } hat bei { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }) und auch sonst keine Höhe.
    .do = Eine andere Linie wählen oder das Loch füllen: { OPTION("fill", "WIDTH") }.

section-no_height_at = { $name } hat bei { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }) keine Höhe.
    .why = Die nächste Höhe ist bei { NUM($nearest, digits: 6) } { $unit }, { $distance } { $unit } entfernt.
    .do = Für { OPTION("between") } eine andere Stelle wählen oder das Loch füllen: { OPTION("fill", "WIDTH") }.

section-partly_measured = { $name }: die mittlere Höhe gilt für { PERCENT($share) } % der Linie.
    .why = Auf dem Rest wurde nichts gemessen.
