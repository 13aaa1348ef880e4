object_line-too_few_points = Objekt { $name }: Die Linie hat weniger als zwei Punkte mit zwei Koordinaten.
    .do = Mindestens zwei Punkte X,Y angeben.

object_line-not_finite = Objekt { $name }: Punkt { $point } der Linie hat eine Koordinate, die keine endliche Zahl ist.
    .do = Die Koordinate korrigieren oder diesen Punkt aus der Linie löschen.

object_line-identical_points = Objekt { $name }: Die Punkte { $first } und { $second } der Linie sind identisch.
    .do = Einen davon löschen.

object_line-too_long = Objekt { $name }: Die Linie ist { $length_m } m lang, mehr als { $largest_m } m.
    .do = Die Einheit der Koordinaten prüfen.
