flight_area-not_finite = Eine Ecke { $kind ->
        [zone] der Flugverbotszone { $name }
        [object] des Objekts
        [outline] des Umrisses { $name }
       *[area] des Gebiets
     } hat keine zwei endlichen Koordinaten.
    .do = Die Ecke korrigieren.

flight_area-too_few_corners = { $kind ->
        [zone] Die Flugverbotszone { $name }
        [object] Das Objekt
        [outline] Der Umriss { $name }
       *[area] Das Gebiet
     } hat { $n } verschiedene Ecken; nötig sind drei.
    .do = Ecken ergänzen.

flight_area-crosses_itself = { $kind ->
        [zone] Die Flugverbotszone { $name }
        [object] Das Objekt
        [outline] Der Umriss { $name }
       *[area] Das Gebiet
     } schneidet sich selbst bei den Seiten ab den Ecken { $first } und { $second }.
    .why = Die Seiten treffen sich bei { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) }.
    .do = Die Ecken in ihrer Folge entlang des Umrisses angeben.

flight_area-no_area = { $kind ->
        [zone] Die Flugverbotszone { $name }
        [object] Das Objekt
        [outline] Der Umriss { $name }
       *[area] Das Gebiet
     } hat keine Ausdehnung: Alle Ecken liegen auf einer Geraden.
    .why = Die Fläche ist { $area } bei einer Länge von { $length }.
    .do = Den Umriss angeben{ $kind ->
        [area] { " " }oder einen Korridor entlang der Linie planen
       *[other] { "" }
     }.
